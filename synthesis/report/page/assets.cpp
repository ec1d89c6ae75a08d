#include "synthesis/report/page/assets.h"

#include <cstddef>

namespace mechwright::assets {

namespace {

// The last byte is a 0 that is not part of the text.
constexpr unsigned char style[] = {
#include "page_style.inc"
};
constexpr unsigned char script[] = {
#include "page_script.inc"
};
constexpr unsigned char moving_script[] = {
#include "page_gif_script.inc"
};
constexpr unsigned char plot_style[] = {
#include "dygraphs_style.inc"
};
constexpr unsigned char plot_script[] = {
#include "dygraphs_script.inc"
};
constexpr unsigned char plot_licence[] = {
#include "dygraphs_licence.inc"
};

template <std::size_t size>
std::string_view text_of(const unsigned char (&bytes)[size]) {
    return {reinterpret_cast<const char*>(bytes), size - 1};
}

}  // namespace

std::string_view page_style() { return text_of(style); }
std::string_view page_script() { return text_of(script); }
std::string_view gif_script() { return text_of(moving_script); }
std::string_view dygraphs_style() { return text_of(plot_style); }
std::string_view dygraphs_script() { return text_of(plot_script); }
std::string_view dygraphs_licence() { return text_of(plot_licence); }

}  // namespace mechwright::assets
