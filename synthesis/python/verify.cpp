#include "synthesis/verify/verify.h"

#include "synthesis/document/document.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/values.h"

namespace mechwright::python {

namespace {

std::vector<Check> checks_of(const nlohmann::ordered_json& document) {
    const pybind11::gil_scoped_release release;
    return mechwright::verify(document);
}

}  // namespace

pybind11::object verify(const pybind11::object& result) {
    return python_of(verification_document(checks_of(result_of(result).document)));
}

}  // namespace mechwright::python
