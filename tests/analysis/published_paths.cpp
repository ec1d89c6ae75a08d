// Path problems without timing: six points on a vertical line, ten points on an ellipse. Vectors as published in the
// programs that accompany Symmetry 14 (2022) 381; every sum of squares was computed anew from the printed digits, on
// the assembly given. A last digit is half a unit of it, or more where the printed angles leave it open.

#include "tests/analysis/published_paths.h"

#include <gtest/gtest.h>

namespace mechwright::test {
namespace {

const std::vector<Vector<double>> vertical_line{{20, 20}, {20, 25}, {20, 30}, {20, 35}, {20, 40}, {20, 45}};

const std::vector<PublishedPath> vertical_line_answers{
    {"Cabrera 2002",
     {39.46629, 8.56291, 19.09486, 47.83886},
     {13.38556, 12.21961},
     {{29.72250, 23.45450}, 6.20163},
     {6.11937, .19304, .44083, .68467, .95835, 1.35533},
     0.036297,
     5.1e-7},
    {"Cabrera 2002, as elsewhere in the programs",
     {39.46629, 8.56291, 19.09486, 47.83886},
     {13.38556, 12.211961},
     {{29.72250, 23.45450}, 6.20163},
     {6.11937, .19304, .44083, .68467, .95835, 1.35533},
     0.035142,
     1.1e-6},  // other printings of the row differ in the digits after these
    {"Acharyya and Mandal, genetic",
     {28.77133, 5, 35.36548, 59.13681},
     {0, 14.85037},
     {{29.91329, 32.60228}, 5.28747},
     {6.28319, .31821, .63852, .97995, 1.41273, 2.07625},
     1.21220,
     5.1e-6},
    {"Acharyya and Mandal, particle swarm",
     {31.15501, 5, 23.84561, 45.80352},
     {39.00066, 18.50846},
     {{59.99999, 17.91696}, 0.41984},
     {4.84241, .40468, .65742, .92209, 1.24707, 2.29873},
     0.298632,
     5.1e-7},
    {"Acharyya and Mandal, differential evolution",
     {35.02074, 6.40420, 31.60722, 50.59949},
     {20.80324, 41.54364},
     {{60, 18.07791}, 0},
     {6.28319, .26494, .50038, .73532, .99653, 1.33355},
     0.0150647,
     5.1e-8},
    {"MUMSA",
     {31.78826, 8.20465, 24.93213, 31.38593},
     {34.19372, 14.41567},
     {{-6.36652, 56.83676}, 4.01596},
     {1.36655, 2.33077, 2.87104, 3.39459, 3.97096, 4.96349},
     2.0627e-4,
     5.1e-9},
    {"Lin and Hsiao",
     {45.95402687932, 10.1413352283990, 36.1198616002200, 49.7905570636800},
     {51.4935231082160, 16.4957302836340},
     {{59.9251894962240, -0.2672551778894}, 0.8623849541875},
     {4.4968313984955, 3.9468529220684, 3.5120853909802, 3.1107812488088, 2.7101093119519, 2.2654986625734},
     4.07e-12,
     5.1e-15},
    {"HCDJ",
     {14.201369, 8.0143127, 16.309922, 12.253871},
     {27.797721, 11.305412},
     {{-2.3095310, 45.695083}, 4.5172417},
     {6.2532447, 2.4038981, 2.9362397, 3.4905751, 4.0650776, 5.2095019},
     1.31e-11,
     5.1e-14},
    {"a column without a name",
     {11.05890, 5.73008, 37.01360, 35.34950},
     {25.54680, 40.55650},
     {{-22.20080, 26.72250}, 0.35480},
     {2.16750, 2.62985, 3.08829, 3.54934, 4.01092, 4.47837},
     2.066e-7,
     5.1e-11,
     Assembly::crossed},
};

TEST(PublishedPaths, OnAVerticalLineMissItAsFarAsStated) {
    for (const PublishedPath& answer : vertical_line_answers)
        EXPECT_NEAR(sum_of_squares(answer, vertical_line), answer.sse, answer.last_digit) << answer.source;
}

TEST(PublishedPaths, AreFarOffInTheOtherAssembly) {
    EXPECT_NEAR(sum_of_squares(vertical_line_answers.back(), vertical_line, Assembly::open), 49647, 0.51);
}

// 10 + 10 cos t, 10 + 8 sin t every 40 degrees, rounded as published; the first point is the last again.
const std::vector<Vector<double>> ellipse{{20, 10},          {17.66, 15.142},   {11.736, 17.878}, {5, 16.928},
                                          {0.60307, 12.736}, {0.60307, 7.2638}, {5, 3.0718},      {11.736, 2.1215},
                                          {17.66, 4.8577},   {20, 10}};

TEST(PublishedPaths, OnAnEllipseMissItAsFarAsStated) {
    const std::vector<PublishedPath> answers{
        {"a column without a name",
         {54.7218, 8.53201, 31.4848, 33.2131},
         {0.423061, 5.9996},
         {{7.30574, 4.88892}, 0.0965143},
         {0, .714643, 1.42348, 2.1297, 2.80325, 3.4741, 4.14885, 4.85494, 5.56444, 6.28318},
         0.00296684,
         5.1e-9,
         Assembly::crossed},
        {"Lin and Hsiao",
         {80, 8.045662, 50.81902, 42.20801},
         {-10.63697, -2.29109},
         {{8.494813, -0.7579678}, 3.88921},
         {2.449437, 3.153969, 3.837114, 4.520171, 5.204799, 5.898536, .316204, 1.023555, 1.738992, 2.449437},
         4.01992e-4,
         5.1e-10},
    };
    for (const PublishedPath& answer : answers)
        EXPECT_NEAR(sum_of_squares(answer, ellipse), answer.sse, answer.last_digit) << answer.source;
}

}  // namespace
}  // namespace mechwright::test
