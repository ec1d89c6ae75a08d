#include "synthesis/document/fields.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/values.h"
#include "synthesis/report/json_text.h"

namespace mechwright::python {

namespace py = pybind11;

py::object result_members() {
    py::dict members;
    for (const Key& key : fields::document)
        members[text_of(key.name)] = key.shape == Shape::tables;
    return members;
}

py::object read_result(const py::object& file) { return python_of(result_of(file).document); }

py::str result_text(const py::dict& result) { return text_of(json_text(result_of(result).document)); }

}  // namespace mechwright::python
