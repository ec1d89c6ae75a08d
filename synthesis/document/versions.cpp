#include "synthesis/document/versions.h"

#include <Eigen/Core>

namespace mechwright {

std::string program_version() { return MECHWRIGHT_VERSION; }
std::string ipopt_version() { return MECHWRIGHT_IPOPT_VERSION; }
std::string nlopt_version() { return MECHWRIGHT_NLOPT_VERSION; }

std::string eigen_version() {
    return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
           std::to_string(EIGEN_MINOR_VERSION);
}

}  // namespace mechwright
