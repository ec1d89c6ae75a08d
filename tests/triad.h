#pragma once
/// \file
/// A linkage that no dyads make.

#include <string>

namespace mechwright::testing {

/// A plate on three links, of which one is driven: a group of four links.
inline const std::string triad_text = R"(schema = 1
mechanism = "linkage"
[links]
frame = { A = [0, 0], D = [4, 0], G = [2, 5] }
crank = { G = [0, 0], H = [1, 0] }
one = { A = [0, 0], P = [3, 0] }
two = { D = [0, 0], Q = [3, 0] }
three = { H = [0, 0], R = [3, 0] }
plate = { P = [0, 0], Q = [2, 0], R = [1, 1] }
[drive]
link = "crank"
)";

}  // namespace mechwright::testing
