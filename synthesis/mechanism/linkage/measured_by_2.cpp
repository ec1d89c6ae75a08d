#include "synthesis/mechanism/linkage/measured_by_series.h"

namespace mechwright::measuring {

template bool measure_by_series<2>(const Over&, std::span<const double>, const Measurement&);

}  // namespace mechwright::measuring
