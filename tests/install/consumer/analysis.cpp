// Prints what kind of linkage 4, 1, 3, 3 is; fails unless it is a crank-rocker.
#include <mechwright/analysis/four_bar.h>

#include <cstdio>
#include <cstring>

int main() {
    const mechwright::FourBar<double> links{4, 1, 3, 3};
    const char* kind = mechwright::name_of(mechwright::classify(links).kind);
    std::puts(kind);
    return std::strcmp(kind, "crank-rocker") == 0 ? 0 : 1;
}
