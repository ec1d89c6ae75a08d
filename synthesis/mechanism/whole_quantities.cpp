#include "synthesis/mechanism/whole_quantities.h"

namespace mechwright {

std::string_view without_whole(std::string_view name) {
    if (name.ends_with(whole_suffix)) name.remove_suffix(whole_suffix.size());
    return name;
}

std::shared_ptr<const Mechanism> with_whole_quantities(const std::shared_ptr<const Mechanism>& mechanism) {
    if (!mechanism->input) return mechanism;
    Mechanism made = *mechanism;
    for (const Quantity& quantity : mechanism->quantities) {
        if (!quantity.of_motion) continue;
        Quantity& whole = made.quantities.emplace_back(quantity);
        whole.name += whole_suffix;
        whole.meaning += "; over the whole motion";
        whole.whole = true;
    }
    return std::make_shared<const Mechanism>(std::move(made));
}

}  // namespace mechwright
