#include "synthesis/python/calls.h"
#include "synthesis/python/values.h"
#include "synthesis/report/names.h"

namespace mechwright::python {

namespace py = pybind11;

py::object quantities(const std::string& name) {
    const std::vector<std::shared_ptr<const Mechanism>> found = mechanisms_named(name);
    if (found.empty()) throw py::value_error(unknown_mechanism(name));
    py::dict all;
    for (const auto& mechanism : found)
        for (const Quantity& quantity : mechanism->quantities) {
            py::dict one;
            one["unit"] = text_of(name_of(quantity.unit));
            one["meaning"] = text_of(quantity.meaning);
            all[text_of(quantity.name)] = one;
        }
    return all;
}

}  // namespace mechwright::python
