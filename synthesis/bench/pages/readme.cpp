#include "synthesis/bench/pages/readme.h"

#include <fmt/format.h>

#include <array>

namespace mechwright::bench {

namespace {

/// Results that other commands and scripts leave in the folder.
struct Beside {
    const char* path;
    const char* what;
};
constexpr std::array beside{
    Beside{"known-optima.md", "problems whose best design is known, and what was reached"},
    Beside{"coverage.md", "which lines and branches the tests run, and why the others do not"},
    Beside{"gallery/README.md", "what every problem that comes with mechwright is solved by, as pictures"},
};

std::string others(const std::filesystem::path& folder) {
    std::string text;
    for (const Beside& b : beside)
        if (std::filesystem::exists(folder / b.path)) text += fmt::format("- [{}]({}): {}\n", b.path, b.path, b.what);
    return text.empty() ? text : "\nOther results:\n\n" + text;
}

std::string chapter_text(const Chapter& chapter) {
    std::string text = fmt::format("\n## {}\n\n{}", chapter.section->title, chapter.text);
    for (const auto& [name, title] : chapter.diagrams)
        text += fmt::format("\n![{}](bench/{}.svg)\n", title, name);
    return text + fmt::format("\nAll rows: [{0}.csv](bench/{0}.csv)\n", chapter.section->name);
}

}  // namespace

std::string readme(const Surroundings& s, const std::vector<Chapter>& chapters, const std::filesystem::path& folder) {
    std::string text = fmt::format(
        "# Speed against error\n\n"
        "Made by `mechwright bench{}`; nothing in it is written by hand. Times are medians of one machine and differ "
        "on\nothers; counts, digits and ratios hardly do. `mechwright bench --out DIR` measures yours.\n\n"
        "- {}\n- {}\n- {}\n- {}; lanes use {}\n",
        s.full ? " --full" : "", s.program, s.compiler, s.libraries, s.processor, s.instructions);
    text += others(folder);
    for (const Chapter& chapter : chapters)
        text += chapter_text(chapter);
    return text;
}

}  // namespace mechwright::bench
