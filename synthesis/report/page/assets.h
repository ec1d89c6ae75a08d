#pragma once
/// \file
/// Files that every page holds: its style and scripts, and the plotting library dygraphs with its licence.

#include <string_view>

namespace mechwright::assets {

std::string_view page_style();
std::string_view page_script();
std::string_view gif_script();
std::string_view dygraphs_style();
std::string_view dygraphs_script();
std::string_view dygraphs_licence();

}  // namespace mechwright::assets
