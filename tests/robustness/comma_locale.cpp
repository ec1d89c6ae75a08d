// Where numbers are written 1.234,5 every command reads and writes the same bytes as elsewhere.

#include "tests/robustness/comma_locale.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <clocale>
#include <sstream>

#include "synthesis/command_line/run.h"
#include "tests/robustness/problems.h"

namespace mechwright::testing {
namespace {

using Lines = std::vector<std::vector<std::string>>;

/// Every command that reads or writes numbers. They run in a folder of their own, one after the other. Numbers on the
/// command line itself are read by the C library in the locale of the process, which in the program is always C.
Lines commands(const std::string& tenths) {
    const std::string given = problem_file("quick-return/drag-link-given"), cam = problem_file("cam/roller-uneven");
    return {{"check", given},
            {"check", "wrong.toml"},
            {"new", "--mechanism", "slider-crank", "--task", "stroke", "--set", "stroke=80" + tenths},
            {"solve", "--out", "out", "--csv", "--quiet", problem_file("four-bar/crank-rocker")},
            {"solve", "--out", "out", "--quiet", cam},
            {"solve", "--json", "--quiet", problem_file("path/case-3")},
            {"compare", "--csv", "--quiet", problem_file("four-bar/crank-rocker"),
             problem_file("four-bar/drag-link-velocity-ratio")},
            {"compare", "--quiet", problem_file("four-bar/crank-rocker")},
            {"analyse", given},
            {"analyse", "--csv", "--steps", "8", given},
            {"verify", "out/crank-rocker.json"},
            {"profile", "out/roller-uneven.json"},
            {"profile", "--dxf", "--cutter", "6" + tenths, "out/roller-uneven.json"},
            {"draw", given, "--out", "made/a.svg", "--plots", "--at", "30" + tenths},
            {"export", given, "--out", "made/a.dxf"},
            {"export", given, "--out", "made/a.csv"},
            {"export", given, "--out", "made/a.json"},
            {"export", given, "--out", "made/a.slvs"},
            {"report", "out"},
            {"study", "study.toml", "--out", "study", "--quiet"},
            {"study", "export", "study", "--csv"},
            {"study", "export", "study", "--json"},
            {"study", "status", "study"},
            {"study", "charts", "study"},
            {"explain", "swing"},
            {"quantities", "four-bar"},
            {"methods", given}};
}

std::string study_with_a_chart() {
    return small_study(5) +
           "[[study.chart]]\nkind = \"curves\"\nname = \"worst\"\nx = \"require.velocity-ratio-max.equal\"\n"
           "value = \"transmission-angle-worst\"\n";
}

/// Without the decimal number that ends before each `mark`; one with a comma would leave a part of itself.
std::string without_number_before(std::string line, std::string_view mark) {
    for (std::size_t at = line.find(mark); at != std::string::npos; at = line.find(mark, at + 1)) {
        std::size_t from = at;
        while (from > 0 && (std::isdigit(static_cast<unsigned char>(line[from - 1])) || line[from - 1] == '.'))
            --from;
        line.erase(from, at - from);
        at = from;
    }
    return line;
}

/// The text without how long something took: in sentences, in documents and in the table of a page.
std::string timeless(const std::string& text) {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        if (line.find("\"seconds\"") != std::string::npos) continue;
        line = without_number_before(line, " s.");
        for (std::size_t at = line.find("seconds"); at != std::string::npos; at = line.find("seconds", at + 1)) {
            const std::size_t cell = line.find("td>", at);
            if (cell == std::string::npos || cell - at > 30) continue;
            const std::size_t number = cell + 3;
            line.erase(number, line.find_first_not_of("0123456789.", number) - number);
        }
        kept += line + "\n";
    }
    return kept;
}

/// Everything the commands say, with their exit codes, and then every file of text that they leave.
template <class RunOne>
std::string all_said(const RunOne& run_one, const std::string& tenths) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path / "made");
    folder.write("wrong.toml", "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = -1234.5\ncrank = 1,5\n");
    folder.write("study.toml", study_with_a_chart());
    std::string all;
    for (const auto& arguments : commands(tenths)) {
        const Outcome outcome = run_one(folder.path.string(), arguments);
        all += "== " + arguments[0] + " " + arguments[1] + ": " + std::to_string(outcome.exit_code) + "\n" +
               timeless(outcome.out) + timeless(outcome.err);
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path))
        if (entry.is_regular_file() && entry.path().extension() != ".sqlite") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files)
        all += "== " + file.lexically_relative(folder.path).string() + "\n" + timeless(content_of(file));
    for (std::size_t at = all.find(folder.path.string()); at != std::string::npos; at = all.find(folder.path.string()))
        all.replace(at, folder.path.string().size(), "FOLDER");
    return all;
}

/// What stands around the first place at which two lines differ.
std::string around(const std::string& line, const std::string& other) {
    const auto same = std::mismatch(line.begin(), line.end(), other.begin(), other.end()).first - line.begin();
    const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(same - 40, 0));
    return from < line.size() ? line.substr(from, 80) : std::string();
}

/// The first line in which two texts differ.
void expect_same_text(const std::string& a, const std::string& b) {
    std::istringstream left(a), right(b);
    std::string heading, one, other;
    while (std::getline(left, one)) {
        std::getline(right, other);
        if (one.starts_with("== ")) heading = one;
        ASSERT_EQ(around(one, other), around(other, one)) << heading;
    }
    EXPECT_EQ(a.size(), b.size());
}

TEST(CommaLocale, ChangesNoByteOfTheProgram) {
    const CommaLocale comma;
    if (!comma.made()) GTEST_SKIP() << "no locale can be made here: localedef or Debian's package locales is missing";
    const auto program = [&](const std::string& name) {
        return all_said(
            [&, name](const std::string& folder, const std::vector<std::string>& arguments) {
                Start how;
                how.arguments = arguments;
                how.folder = folder;
                how.environment = {{"LOCPATH", comma.path()}, {"LC_ALL", name}};
                return run(how);
            },
            ".5");
    };
    const std::string plain = program("C");
    expect_has(plain, "-1234.5");
    expect_has(plain, "45.008219");
    expect_same_text(program(comma_name), plain);
}

/// The program in this process, as a library is that somebody else's program has given a locale.
Outcome run_here(const std::string& folder, const std::vector<std::string>& arguments) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    std::ostringstream out, err;
    Console console{out, err};
    std::vector<const char*> words{"mechwright"};
    for (const std::string& argument : arguments)
        words.push_back(argument.c_str());
    const int code = mechwright::run(static_cast<int>(words.size()), words.data(), console);
    std::filesystem::current_path(before);
    return {code, 0, out.str(), err.str()};
}

TEST(CommaLocale, OfTheWholeProcessChangesNoByteEither) {
    const std::string plain = all_said(run_here, "");
    const CommaLocale comma;
    const std::string before = std::setlocale(LC_ALL, nullptr);
    ::setenv("LOCPATH", comma.path().c_str(), 1);
    const bool set = std::setlocale(LC_ALL, comma_name) != nullptr;
    const std::string point = std::localeconv()->decimal_point;
    const std::locale global = std::locale::global(std::locale(std::locale(), new CommaNumbers));
    std::ostringstream number;
    number << 1234.5;
    const std::string said = all_said(run_here, "");
    std::locale::global(global);
    std::setlocale(LC_ALL, before.c_str());
    ::unsetenv("LOCPATH");
    EXPECT_EQ(number.str(), "1.234,5");
    EXPECT_EQ(set, comma.made());
    EXPECT_EQ(point, comma.made() ? "," : ".");
    expect_same_text(said, plain);
}

}  // namespace
}  // namespace mechwright::testing
