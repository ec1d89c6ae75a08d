#pragma once
/// \file
/// What a name means: a quantity, a dimension, a setting, a mechanism, a signal, or a section or key of a problem file.

#include <string>

namespace mechwright {

struct Explained {
    std::string text;
    std::string fault;  ///< why there is none, and what to write instead; empty if there is one
};

/// All meanings of the name, or those that it has for one mechanism.
Explained explained(const std::string& name, const std::string& mechanism, bool colour);

}  // namespace mechwright
