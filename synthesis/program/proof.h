#pragma once
/// \file
/// Why an answer is the whole answer: no design meets the requirements, or none is better than the one that was found.

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace mechwright {

/// A place on a cam's motion: at part u of a segment, on one of its analytic pieces.
struct CamPlace {
    std::size_t segment = 0;
    std::size_t piece = 0;
    double u = 0;
};

/// A half-plane that the centre of a cam with a roller follower has to lie in, with its weight.
struct WeightedHalfPlane {
    enum class Origin { pressure_angle, height, least_offset, greatest_offset };
    Origin origin = Origin::pressure_angle;
    CamPlace place{};   ///< of a pressure angle
    double limit = 0;   ///< on it, radians
    int side = 1;       ///< +1: the angle is at most the limit, -1: at least its negative
    double weight = 0;  ///< >= 0
};

/// Weighted half-planes keep the cam centre at a distance: no cam has a prime radius or pivot distance below it. A list
/// for each assembly.
struct HalfPlaneCertificate {
    struct Part {
        std::size_t assembly = 0;
        std::vector<WeightedHalfPlane> rows{};
    };
    std::size_t dimension = 0;  ///< whose least value is bounded
    std::vector<Part> parts{};
};

/// Where a flat face asks for the largest cam: no base radius or pivot distance below that gives the radius of
/// curvature there. One place for each assembly.
struct CurvatureCertificate {
    struct Part {
        std::size_t assembly = 0;
        CamPlace place{};
    };
    std::size_t dimension = 0;
    std::vector<Part> parts{};
};

/// A limit in closed form on a quantity of any design that meets the other requirements.
struct LimitCertificate {
    std::string name;          ///< as in synthesis/proof/known_limits.h
    std::size_t quantity = 0;  ///< that is limited
    double value = 0;          ///< lengths or radians
};

/// Branch and bound: no design is better than the bound that the report has.
struct BoundCertificate {};
/// Every solution of a system of equations is accounted for: the counts that the report has.
struct CountCertificate {};
/// What is minimised cannot be negative, and is zero but for rounding.
struct ZeroCertificate {};
/// Every dimension is given, or nothing is to be made greatest or least: a design that meets the requirements is the
/// answer, and where every dimension is given one that does not shows that there is none.
struct GivenCertificate {};
/// By their ranges alone the lengths make no linkage of a kind that is asked for.
struct RangesCertificate {};

using Certificate = std::variant<HalfPlaneCertificate, CurvatureCertificate, LimitCertificate, BoundCertificate,
                                 CountCertificate, ZeroCertificate, GivenCertificate, RangesCertificate>;

/// There is none without a certificate, which verification evaluates from the document alone.
struct Proof {
    std::string argument;  ///< in words
    Certificate certificate;
};

inline std::shared_ptr<const Proof> proof_by(std::string argument, Certificate certificate) {
    return std::make_shared<const Proof>(Proof{std::move(argument), std::move(certificate)});
}

}  // namespace mechwright
