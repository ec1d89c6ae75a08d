#pragma once
/// \file
/// results/README.md.

#include <filesystem>
#include <string>
#include <vector>

#include "synthesis/bench/record.h"

namespace mechwright::bench {

struct Chapter {
    const Section* section;
    std::string text;
    struct Drawn {
        std::string name;
        std::string title;
    };
    std::vector<Drawn> diagrams;
};

/// The whole file. `folder` is where it will stand: other results beside it are named.
std::string readme(const Surroundings& surroundings, const std::vector<Chapter>& chapters,
                   const std::filesystem::path& folder);

}  // namespace mechwright::bench
