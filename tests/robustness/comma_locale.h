#pragma once
/// \file
/// A locale that writes 1.234,5: Debian's German one, made in a folder of its own where the system has none.

#include <gtest/gtest.h>

#include <cstdlib>
#include <locale>
#include <string>

#include "tests/report/temporary_folder.h"

namespace mechwright::testing {

inline constexpr const char* comma_name = "de_DE.UTF-8";

/// A folder with the compiled locale in it, for LOCPATH.
class CommaLocale {
public:
    CommaLocale() {
        const std::string command = std::string("localedef -i de_DE -f UTF-8 '") + folder_ / comma_name + "'";
        made_ = std::system((command + " >/dev/null 2>&1").c_str()) == 0;
    }
    bool made() const { return made_; }
    std::string path() const { return folder_.path.string(); }

private:
    TemporaryFolder folder_;
    bool made_ = false;
};

/// What C++ streams take for numbers.
struct CommaNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

}  // namespace mechwright::testing
