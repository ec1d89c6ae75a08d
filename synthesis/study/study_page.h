#pragma once
/// \file
/// The page on a study: its charts, and the designs behind their points.

#include <cstdint>
#include <filesystem>

#include "synthesis/report/page/page.h"

namespace mechwright {

/// At most so many designs, evenly chosen, are in the page. Throws StoreFault where there are no data, ChartFault where
/// charts cannot be drawn.
Page study_page(const std::filesystem::path& data, std::uint64_t most_designs);

}  // namespace mechwright
