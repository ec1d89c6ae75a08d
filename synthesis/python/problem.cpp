#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/toml/made_table.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/values.h"

namespace mechwright::python {

namespace py = pybind11;

void read(const py::object& problem) { problem_of(problem); }

py::object plain(const py::dict& dict, bool nulls) {
    return python_of(json_of(dict, nulls ? Absent::null : Absent::refused), Lists::plain);
}

py::object problem_keys() {
    py::list names;
    for (const Key& key : keys::of_file())
        names.append(text_of(key.name));
    return names;
}

py::str problem_text(const py::dict& problem) {
    return text_of(reading::text_of(reading::made_table(json_of(problem, Absent::refused)).table));
}

}  // namespace mechwright::python
