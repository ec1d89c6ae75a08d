#include "synthesis/exact/poses/dyads.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/exact/poses/dyad_equation.h"
#include "synthesis/exact/poses/orthogonal_basis.h"

namespace mechwright {

namespace {

using Complex = std::complex<double>;
using Seven = Eigen::Matrix<Complex, 7, 1>;
using Plane = Eigen::Matrix<double, 7, 3>;
using Conic = Eigen::Matrix3d;
using Point = Eigen::Vector3cd;  ///< of the projective plane

/// Below this, relative, a number is taken for zero where rounding alone would make it so.
constexpr double zero_within = 1e-11;
/// Pivots farther away than this, lengths being near 1, are those of sliders.
constexpr double infinite_beyond = 1e7;

/// The quadratic forms that vanish for sevens that come from a dyad: of the real and of the imaginary part.
std::array<Eigen::Matrix<double, 7, 7>, 2> product_forms() {
    std::array<Eigen::Matrix<double, 7, 7>, 2> forms;
    const auto set = [](auto& form, int i, int j, double value) { form(i, j) = form(j, i) = 0.5 * value; };
    for (auto& form : forms)
        form.setZero();
    set(forms[0], 3, 1, 1);
    set(forms[0], 4, 2, 1);
    set(forms[0], 5, 0, -1);
    set(forms[1], 4, 1, 1);
    set(forms[1], 3, 2, -1);
    set(forms[1], 6, 0, -1);
    return forms;
}

double determinant(const Conic& a) { return a.determinant(); }

/// The real roots of c0 + c1 t + c2 t^2 + t^3, and the real parts of a pair that rounding may have made complex: the
/// eigenvalues of the companion matrix, which is upper Hessenberg as it stands.
std::vector<double> real_roots(double c0, double c1, double c2) {
    Eigen::Matrix3d companion;
    companion << 0, 0, -c0, 1, 0, -c1, 0, 1, -c2;
    if (!companion.allFinite()) return {};
    const double scale = companion.cwiseAbs().maxCoeff();
    Eigen::RealSchur<Eigen::Matrix3d> schur(3);
    schur.computeFromHessenberg(companion / scale, Eigen::Matrix3d::Identity(), false);
    const Eigen::Matrix3d t = scale * schur.matrixT();
    std::vector<double> roots;
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (i == 2 || t(i + 1, i) == 0) {
            roots.push_back(t(i, i));
            continue;
        }
        const double half = 0.5 * (t(i, i) - t(i + 1, i + 1)), real = t(i + 1, i + 1) + half;
        const double imaginary = std::sqrt(std::abs(half * half + t(i + 1, i) * t(i, i + 1)));
        if (imaginary <= 1e-6 * std::hypot(real, imaginary)) roots.push_back(real);
        ++i;
    }
    return roots;
}

/// The degenerate conics of a pencil cos a A + sin a B, as angles a: det is a cubic form of (cos a, sin a).
std::vector<double> degenerate_members(const Conic& A, const Conic& B) {
    // Turned by an angle without meaning, so that the cubic does not lose its degree where A or B is degenerate itself.
    const double turn = 0.7;
    const Conic P = std::cos(turn) * A + std::sin(turn) * B, Q = -std::sin(turn) * A + std::cos(turn) * B;
    const double plus = determinant(P + Q), minus = determinant(P - Q);
    const double c0 = determinant(P), c3 = determinant(Q);
    const double c2 = 0.5 * (plus + minus) - c0, c1 = 0.5 * (plus - minus) - c3;
    const double size = std::abs(c0) + std::abs(c1) + std::abs(c2) + std::abs(c3);
    std::vector<double> angles;
    if (!(size > 0)) return angles;
    if (std::abs(c3) < zero_within * size) angles.push_back(turn + std::acos(0.0));
    if (std::abs(c3) > 0)
        for (const double t : real_roots(c0 / c3, c1 / c3, c2 / c3))
            angles.push_back(turn + std::atan(t));
    return angles;
}

/// Both points of a line on a conic.
void add_points_on(const Point& line, const Conic& conic, std::vector<Point>& out) {
    Eigen::Index k = 0;
    line.cwiseAbs().maxCoeff(&k);
    std::array<Point, 2> base;
    for (Eigen::Index j = 0, at = 0; j < 3; ++j) {
        if (j == k) continue;
        base[static_cast<std::size_t>(at)] = Point::Unit(j);
        base[static_cast<std::size_t>(at++)][k] = -line[j] / line[k];
    }
    const auto form = [&](const Point& a, const Point& b) {
        const Point product = conic.cast<Complex>() * b;
        return a[0] * product[0] + a[1] * product[1] + a[2] * product[2];
    };
    const Complex alpha = form(base[0], base[0]), beta = form(base[0], base[1]), gamma = form(base[1], base[1]);
    const Complex root = std::sqrt(beta * beta - alpha * gamma);
    const Complex q = std::norm(beta + root) > std::norm(beta - root) ? -(beta + root) : -(beta - root);
    out.push_back(q * base[0] + alpha * base[1]);
    out.push_back(gamma * base[0] + q * base[1]);
}

/// The points of two conics by way of a degenerate one of their pencil: a pair of lines.
std::vector<Point> common_points(const Conic& A, const Conic& B, double angle) {
    const Conic pair = std::cos(angle) * A + std::sin(angle) * B;
    const Conic other = -std::sin(angle) * A + std::cos(angle) * B;
    const Eigen::SelfAdjointEigenSolver<Conic> eigen(pair);
    Eigen::Index least = 0;
    eigen.eigenvalues().cwiseAbs().minCoeff(&least);
    const Eigen::Index i = (least + 1) % 3, j = (least + 2) % 3;
    const Point a = std::sqrt(Complex(eigen.eigenvalues()[i])) * eigen.eigenvectors().col(i).cast<Complex>();
    const Point b = std::sqrt(Complex(-eigen.eigenvalues()[j])) * eigen.eigenvectors().col(j).cast<Complex>();
    std::vector<Point> points;
    add_points_on(a + b, other, points);
    add_points_on(a - b, other, points);
    return points;
}

/// Newton's corrections on the conditions themselves; the last one's relative size.
double correct(const DyadConditions& c, ComplexDyad& dyad) {
    constexpr int most = 6;
    double last = 1;
    for (int k = 0; k < most; ++k) {
        const auto& [u, v] = dyad.fixed;
        const auto& [p, q] = dyad.moving;
        Eigen::Vector4cd values;
        Eigen::Matrix4cd slopes;
        for (Eigen::Index i = 0; i < 4; ++i) {
            const auto equation = dyad_equation(c.row(i), u, v, p, q);
            values[i] = equation.value;
            for (Eigen::Index j = 0; j < 4; ++j)
                slopes(i, j) = equation.slopes[static_cast<std::size_t>(j)];
        }
        const Eigen::Vector4cd change = slopes.partialPivLu().solve(values);
        if (!change.allFinite()) return 1;
        dyad.fixed[0] -= change[0];
        dyad.fixed[1] -= change[1];
        dyad.moving[0] -= change[2];
        dyad.moving[1] -= change[3];
        const double size = std::max({std::abs(dyad.fixed[0]), std::abs(dyad.fixed[1]), std::abs(dyad.moving[0]),
                                      std::abs(dyad.moving[1]), 1e-3});
        const double now = change.cwiseAbs().maxCoeff() / size;
        if (k > 1 && now >= last) return last;
        last = now;
    }
    return last;
}

double distance(const ComplexDyad& a, const ComplexDyad& b) {
    double apart = 0, size = 1;
    for (std::size_t k = 0; k < 2; ++k) {
        apart = std::max({apart, std::abs(a.fixed[k] - b.fixed[k]), std::abs(a.moving[k] - b.moving[k])});
        size = std::max({size, std::abs(a.fixed[k]), std::abs(a.moving[k])});
    }
    return apart / size;
}

/// Sorts the common points into dyads, those at infinity, and those that coincide.
DyadSolutions dyads_at(const std::vector<Point>& points, const Plane& plane, const DyadConditions& conditions) {
    constexpr double regular_below = 1e-9, same_within = 1e-6;
    DyadSolutions found;
    for (const Point& point : points) {
        const Seven seven = plane.cast<Complex>() * point;
        const double size = seven.cwiseAbs().maxCoeff();
        if (!(std::abs(seven[0]) * infinite_beyond > size)) {
            ++(size > 0 ? found.at_infinity : found.singular);
            continue;
        }
        ComplexDyad dyad{{seven[1] / seven[0], seven[2] / seven[0]}, {seven[3] / seven[0], seven[4] / seven[0]}};
        const bool regular = correct(conditions, dyad) < regular_below;
        const bool known = std::any_of(found.dyads.begin(), found.dyads.end(),
                                       [&](const ComplexDyad& other) { return distance(dyad, other) < same_within; });
        if (regular && !known) {
            found.dyads.push_back(dyad);
            continue;
        }
        ++found.singular;
        found.unsettled.push_back(dyad);
    }
    return found;
}

DyadCondition as_condition(const std::array<double, 7>& factors) {
    return Eigen::Map<const DyadCondition>(factors.data());
}

Vector<double> plain(Complex z) { return {z.real(), z.imag()}; }

DyadCondition on_line(Complex point, Complex direction, std::size_t first) {
    return as_condition(line_factors(plain(point), plain(direction / std::abs(direction)), first));
}

/// A condition as one on the moving pivot alone, for a given fixed pivot: (of x.x, of x.y, constant).
Eigen::RowVector3d on_moving_pivot(const DyadCondition& c, Complex fixed) {
    const auto equation = dyad_equation(c, fixed.real(), fixed.imag(), 0.0, 0.0);
    return {equation.slopes[2], equation.slopes[3], equation.value};
}

/// What conditions leave of four of their columns, chosen by an angle where that are two dimensions, by two where
/// three.
std::optional<Eigen::Vector4d> left_by(std::span<const Displacement> displacements,
                                       const std::array<Eigen::Index, 4>& columns, std::span<const double> numbers) {
    const auto count = static_cast<Eigen::Index>(displacements.size());
    Eigen::Matrix4d rows = Eigen::Matrix4d::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        const DyadCondition condition = condition_of(displacements[static_cast<std::size_t>(i)]);
        for (Eigen::Index j = 0; j < 4; ++j)
            rows(i, j) = condition[columns[static_cast<std::size_t>(j)]];
        if (const double size = rows.row(i).norm(); size > 0) rows.row(i) /= size;
    }
    const Eigen::ColPivHouseholderQR<Eigen::Matrix4d> qr(rows.transpose());
    if (!(std::abs(qr.matrixR()(count - 1, count - 1)) > zero_within * std::abs(qr.matrixR()(0, 0))))
        return std::nullopt;
    const Eigen::Matrix4d basis = orthogonal_basis(qr);
    const auto angle = [&](std::size_t k) { return k < numbers.size() ? std::numbers::pi * numbers[k] : 0.0; };
    Eigen::Vector4d left = std::cos(angle(0)) * basis.col(3);
    if (count <= 2) left += std::sin(angle(0)) * std::cos(angle(1)) * basis.col(2);
    if (count == 1) left += std::sin(angle(0)) * std::sin(angle(1)) * basis.col(1);
    return left;
}

}  // namespace

DyadCondition condition_of(const Displacement& displacement) {
    return as_condition(dyad_factors(plain(displacement.shift), plain(displacement.turn)));
}

DyadCondition fixed_pivot_on_line(Complex point, Complex direction) { return on_line(point, direction, 1); }
DyadCondition moving_pivot_on_line(Complex point, Complex direction) { return on_line(point, direction, 3); }

DyadSolutions dyads_meeting(const DyadConditions& conditions) {
    DyadConditions rows = conditions;
    for (Eigen::Index i = 0; i < 4; ++i)
        if (const double size = rows.row(i).norm(); size > 0) rows.row(i) /= size;
    const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 7, 4>> qr(rows.transpose());
    DyadSolutions found;
    found.isolated = std::abs(qr.matrixR()(3, 3)) > zero_within * std::abs(qr.matrixR()(0, 0));
    if (!found.isolated) return found;
    const Eigen::Matrix<double, 7, 7> basis = orthogonal_basis(qr);
    const Plane plane = basis.rightCols<3>();
    static const auto forms = product_forms();
    std::array<Conic, 2> conics;
    for (std::size_t k = 0; k < 2; ++k) {
        conics[k] = plane.transpose() * forms[k] * plane;
        conics[k] /= conics[k].norm();
    }
    DyadSolutions best;
    best.isolated = false;
    for (const double angle : degenerate_members(conics[0], conics[1])) {
        const DyadSolutions now = dyads_at(common_points(conics[0], conics[1], angle), plane, rows);
        if (!best.isolated || now.dyads.size() + now.at_infinity > best.dyads.size() + best.at_infinity) best = now;
        if (best.singular == 0) break;
    }
    return best;
}

DyadSolutions dyads_through(std::span<const Displacement, 4> displacements) {
    DyadConditions conditions;
    for (Eigen::Index i = 0; i < 4; ++i)
        conditions.row(i) = condition_of(displacements[static_cast<std::size_t>(i)]);
    return dyads_meeting(conditions);
}

std::optional<Dyad> dyad_with_fixed_pivot(Complex fixed, std::span<const Displacement, 2> displacements) {
    Eigen::Matrix<double, 2, 3> rows;
    rows << on_moving_pivot(condition_of(displacements[0]), fixed),
        on_moving_pivot(condition_of(displacements[1]), fixed);
    const Eigen::Vector3d cross = rows.row(0).transpose().cross(Eigen::Vector3d(rows.row(1)));
    const Complex moving(cross[0] / cross[2], cross[1] / cross[2]);
    if (!(std::abs(moving) < infinite_beyond)) return std::nullopt;
    return Dyad{fixed, moving};
}

std::optional<Line> moving_pivots_of(Complex fixed, const Displacement& displacement) {
    const Eigen::RowVector3d row = on_moving_pivot(condition_of(displacement), fixed);
    const Complex normal(row[0], row[1]);
    const double size = std::norm(normal);
    if (!(size > 0)) return std::nullopt;
    return Line{-row[2] / size * normal, Complex(0, 1) * normal / std::sqrt(size)};
}

std::optional<SliderDyad> slider_through(std::span<const Displacement> displacements, std::span<const double> numbers) {
    const auto left = left_by(displacements, {1, 2, 5, 6}, numbers);
    if (!left) return std::nullopt;
    const Complex normal((*left)[0], (*left)[1]), product((*left)[2], (*left)[3]);
    const Complex moving = product / std::conj(normal);
    if (!(std::abs(moving) < infinite_beyond)) return std::nullopt;
    return SliderDyad{moving, normal / std::abs(normal)};
}

std::optional<Dyad> real_dyad(const ComplexDyad& dyad) {
    constexpr double real_within = 1e-9;
    double size = 1e-3, imaginary = 0;
    for (const auto* pivot : {&dyad.fixed, &dyad.moving})
        for (const Complex& z : *pivot) {
            size = std::max(size, std::abs(z));
            imaginary = std::max(imaginary, std::abs(z.imag()));
        }
    if (!(imaginary <= real_within * size)) return std::nullopt;
    return Dyad{{dyad.fixed[0].real(), dyad.fixed[1].real()}, {dyad.moving[0].real(), dyad.moving[1].real()}};
}

double residual(const ComplexDyad& dyad, const Displacement& displacement) {
    const auto& [u, v] = dyad.fixed;
    const auto& [p, q] = dyad.moving;
    const std::array<Complex, 7> seven{1, u, v, p, q, p * u + q * v, q * u - p * v};
    const DyadCondition row = condition_of(displacement);
    Complex sum = 0;
    double size = 0;
    for (std::size_t i = 0; i < 7; ++i) {
        const Complex term = row[static_cast<Eigen::Index>(i)] * seven[i];
        sum += term;
        size += std::abs(term);
    }
    return size > 0 ? std::abs(sum) / size : 0;
}

}  // namespace mechwright
