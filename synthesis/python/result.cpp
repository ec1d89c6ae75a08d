#include "synthesis/document/fields.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/values.h"
#include "synthesis/report/drawing/finished.h"
#include "synthesis/report/drawing/svg.h"
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

py::str picture(const py::object& result) {
    const ResultArgument read = result_of(result);
    const FinishedOrNot finished = finished_design(read.document);
    if (!finished.defect.empty()) refuse_result(read.name, finished.defect);
    if (!finished.design.assembles()) refuse_result(read.name, "its design does not assemble at any crank angle");
    const auto& problem = read.document["problem"];
    const auto title = problem.find("title");
    SvgPicture picture;
    if (title != problem.end() && title->is_string()) picture.title = title->get<std::string>();
    return text_of(svg_picture(finished.design, picture));
}

}  // namespace mechwright::python
