#include "synthesis/target/followed/numbers.h"

namespace mechwright {

void add_shape(Mechanism& m, FollowedShape& shape) {
    shape.place = m.dimensions.size();
    m.dimensions.insert(m.dimensions.end(), shape.numbers.begin(), shape.numbers.end());
    for (Quantity& q : shape.quantities)
        q.reads = q.reads.and_then(m.input->start, 2).and_then(shape.place, shape.numbers.size());
}

}  // namespace mechwright
