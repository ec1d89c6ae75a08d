#include "synthesis/target/followed/verify.h"

namespace mechwright {

Check check_full_turn(const Rebuilt& design) {
    const bool passed = turns_fully(design);
    return {"the crank turns fully", passed, passed ? "it does" : "it does not"};
}

}  // namespace mechwright
