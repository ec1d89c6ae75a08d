// Path problems with prescribed timing: five points, a closed curve of 18 points, a semicircle. Vectors as published in
// the programs that accompany Symmetry 14 (2022) 381 (the rows named "best known" were found for this project); every
// sum of squares was computed anew from the printed digits.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/analysis/precise.h"
#include "tests/analysis/published_paths.h"

namespace mechwright::test {
namespace {

void expect_stated(const std::vector<PublishedPath>& answers, const std::vector<Vector<double>>& targets) {
    for (const PublishedPath& answer : answers)
        EXPECT_NEAR(sum_of_squares(answer, targets), answer.sse, answer.last_digit) << answer.source;
}

std::vector<double> even_angles(double first, double step_degrees, int count) {
    std::vector<double> angles;
    for (int i = 0; i < count; ++i)
        angles.push_back(first + i * step_degrees * degree);
    return angles;
}

TEST(PublishedTimedPaths, ThroughFivePointsMissThemAsFarAsStated) {
    const std::vector<Vector<double>> targets{{3, 3}, {2.759, 3.363}, {2.372, 3.663}, {1.890, 3.862}, {1.355, 3.943}};
    const auto angles = even_angles(std::numbers::pi / 6, 15, 5);
    const Placement<double> home{{0, 0}, 0};
    expect_stated(
        {{"Kunjur and Krishnamurty 1997",
          {3.509643, 1.857606, 4.725835, 3.518721},
          {1.959538, 1.558898},
          home,
          angles,
          9.5264e-4,
          5.1e-9},
         {"Cabrera 2002",
          {3.0630424, 1.9959624, 3.305823, 2.524706},
          {1.645158, 1.708959},
          home,
          angles,
          1.82703e-6,
          5.1e-12},
         {"MUMSA",
          {3.77326856, 2.00000403, 4.11697104, 2.74615671},
          {1.67848787, 1.67098007},
          home,
          angles,
          1.28400e-6,
          5.1e-12},
         {"IOA", {2.803607, 1.99226, 3.030461, 2.474117}, {1.64413, 1.714536}, home, angles, 4.27044e-6, 5.1e-12},
         {"HCDJ",
          {4.2930812, 1.9978324, 4.7374099, 2.9417301},
          {1.7074051, 1.6441696},
          home,
          angles,
          1.92394e-6,
          5.1e-12},
         {"best known",
          {3.66973014, 1.99781214, 3.99631780, 2.70488650},
          {1.67204633, 1.68013214},
          home,
          angles,
          7.415751307e-7,
          5.1e-15}},
        targets);
}

TEST(PublishedTimedPaths, RoundAClosedCurveMissItAsFarAsStated) {
    const std::vector<Vector<double>> targets{{0.5, 1.1},   {0.4, 1.1},  {0.3, 1.1}, {0.2, 1.0}, {0.1, 0.9},
                                              {0.05, 0.75}, {0.02, 0.6}, {0, 0.5},   {0, 0.4},   {0.03, 0.3},
                                              {0.1, 0.25},  {0.15, 0.2}, {0.2, 0.3}, {0.3, 0.4}, {0.4, 0.5},
                                              {0.5, 0.7},   {0.6, 0.9},  {0.6, 1.0}};
    const auto angles = [](double first) { return even_angles(first, 20, 18); };
    expect_stated({{"Kunjur and Krishnamurty",
                    {1.87966, 0.274853, 1.180253, 2.138209},
                    {-0.833592, -0.378770},
                    {{1.132062, 0.663433}, 4.354224},
                    angles(2.558625),
                    0.066072,
                    5.1e-7},
                   {"Cabrera 2002",
                    {3.057878, 0.237803, 4.828954, 2.056456},
                    {0.767038, 1.850828},
                    {{1.776808, -0.641991}, 1.002168},
                    angles(0.226186),
                    0.033748,
                    5.1e-7},
                   {"IOA",
                    {4.040435, 0.245216, 6.38294, 2.620532},
                    {1.139106, 1.866109},
                    {{1.891805, -0.761339}, 1.187751},
                    angles(0),
                    0.034988,
                    5.1e-7},
                   {"MUMSA",
                    {4.453772, 0.297057, 3.913095, 0.849372},
                    {-2.067338, 1.6610626},
                    {{-1.309243, 2.806964}, 2.7387359},
                    angles(4.853543),
                    0.0194055,
                    5.1e-8},
                   {"HCDJ",
                    {49.800886, 0.28817159, 48.476138, 1.6336420},
                    {-23.412810, 7.6644886},
                    {{-14.836153, 20.140223}, 2.5286091},
                    angles(5.0644224),
                    0.0160777,
                    5.1e-8},
                   {"Bulatovic and others 2016",
                    {1.00429, 0.42180, 0.87821, 0.58013},
                    {0.5234 * std::cos(0.8148), 0.5234 * std::sin(0.8148)},
                    {{0.26886, 0.17715}, 0.29294},
                    angles(0.886243),
                    0.00911498,
                    5.1e-9},
                   {"best known",
                    {1.05394344, 0.42387499, 0.91424983, 0.59891689},
                    {0.37059736, 0.39934666},
                    {{0.2676555, 0.15464956}, 0.28482455},
                    angles(0.89155585),
                    0.009028884631,
                    5.1e-13},
                   {"best known, its cognate",
                    {0.77763389, 0.31274882, 0.44190044, 0.67456339},
                    {-0.04078607, -0.35456335},
                    {{0.54830862, 0.7165121}, 5.93446225},
                    angles(0.89155585),
                    0.009028884631,
                    5.1e-13,
                    Assembly::crossed}},
                  targets);
}

TEST(PublishedTimedPaths, OnASemicircleMissItAsFarAsStated) {
    const std::vector<Vector<double>> targets{{0, 0},          {1.9098, 5.8779}, {6.9098, 9.5106},
                                              {13.09, 9.5106}, {18.09, 5.8779},  {20, 0}};
    const auto angles = even_angles(std::numbers::pi / 6, 30, 6);
    expect_stated({{"column 1",
                    {49.994859, 5, 5.915643, 49.994867},
                    {18.925715, 0},
                    {{14.472475, -12.494409}, 0.467287},
                    angles,
                    5.54724,
                    5.1e-6},
                   {"column 2",
                    {50, 5, 5.905345, 50},
                    {18.819312, 0},
                    {{14.373772, -12.444295}, 0.463633},
                    angles,
                    5.52069,
                    5.1e-6},
                   {"column 3",
                    {50, 5, 7.031047, 48.134183},
                    {16.976687, 12.952139},
                    {{12.197494, -15.998203}, 0.0428247},
                    angles,
                    2.580356,
                    5.1e-7},
                   {"column 6",
                    {60, 5, 7.06916, 58.1241},
                    {16.8655, 13.0576},
                    {{11.8936, -16.0037}, 6.28318},
                    angles,
                    2.231381,
                    5.1e-7},
                   {"column 4, HCDJ: a kite",
                    {49.999217, 1.3476638, 1.3476825, 49.999235},
                    {11.383058, 4.4426855},
                    {{10.1944353, -3.6925458}, 6.2157809},
                    angles,
                    1.21622,
                    5.1e-6},
                   {"best known with Grashof margin 0.05",
                    {50, 3.11325111, 3.50931749, 49.6539336},
                    {14.0593107, 6.73384594},
                    {{10.9037762, -8.56281347}, 0.0114110479},
                    angles,
                    1.79823,
                    5.1e-6},
                   {"best known with Grashof margin 0.2",
                    {50, 4.40345552, 5.6425472, 48.96090832},
                    {16.93507679, 9.06336709},
                    {{12.11689129, -13.27137899}, 0.1043167},
                    angles,
                    2.47253,
                    5.1e-6}},
                  targets);
}

TEST(PublishedTimedPaths, HaveTheTransmissionAnglesStated) {
    struct Row {
        FourBar<double> links;
        double least, greatest;
    };
    for (const Row& row : {Row{{3.66973014, 1.99781214, 3.99631780, 2.70488650}, 18.6, 114.1},
                           Row{{1.05394344, 0.42387499, 0.91424983, 0.59891689}, 43.3, 154.6},
                           Row{{50, 3.11325111, 3.50931749, 49.6539336}, 36.7, 170.0},
                           Row{{50, 4.40345552, 5.6425472, 48.96090832}, 50.7, 163.9}}) {
        EXPECT_NEAR(transmission_angle(row.links, {1, 0}) / degree, row.least, 0.051);
        EXPECT_NEAR(transmission_angle(row.links, {0, 1}) / degree, row.greatest, 0.051);
    }
}

TEST(PublishedTimedPaths, HaveTheGrashofMarginsStated) {
    EXPECT_NEAR(grashof_margin(FourBar<double>{3.66973014, 1.99781214, 3.99631780, 2.70488650}), 0.38, 5.1e-3);
    EXPECT_NEAR(grashof_margin(FourBar<double>{1.05394344, 0.42387499, 0.91424983, 0.59891689}), 0.0353, 5.1e-5);
    EXPECT_NEAR(grashof_margin(FourBar<double>{50, 3.11325111, 3.50931749, 49.6539336}), 0.05, 1e-7);
    EXPECT_NEAR(grashof_margin(FourBar<double>{50, 4.40345552, 5.6425472, 48.96090832}), 0.2, 1e-7);
    // The kite that wins the semicircle lies on the limit; its eight digits leave a margin of seven in the last place.
    EXPECT_NEAR(grashof_margin(FourBar<double>{49.999217, 1.3476638, 1.3476825, 49.999235}), 7e-7, 1e-12);
}

}  // namespace
}  // namespace mechwright::test
