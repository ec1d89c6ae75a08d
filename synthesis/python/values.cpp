#include "synthesis/python/values.h"

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/problem/text.h"
#include "synthesis/problem/toml/made_table.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;

constexpr int deepest = 32;  // far deeper than any problem or result goes

struct Taking {
    Absent absent;
    py::object numpy_scalar;
};

std::string named(const std::string& place) { return place.empty() ? "the dict" : place; }

[[noreturn]] void refuse_type(const py::handle& value, const std::string& place) {
    throw py::type_error(
        fmt::format("{}: a {}; write a dict, a list, an array, a number, a string, True or False", named(place),
                    reading::printable(py::str(py::type::handle_of(value).attr("__name__")).cast<std::string>(), 100)));
}

/// Throws what Python has raised with the place in front, where it is not Ctrl-C or the like.
[[noreturn]] void refuse_value(py::error_already_set& error, const std::string& place) {
    if (!error.matches(PyExc_Exception)) throw error;
    throw py::value_error(named(place) + ": " + py::str(error.value()).cast<std::string>());
}

std::string string_of(const py::handle& value, const std::string& place) {
    Py_ssize_t size = 0;
    if (const char* bytes = PyUnicode_AsUTF8AndSize(value.ptr(), &size)) return {bytes, static_cast<std::size_t>(size)};
    PyErr_Clear();
    throw py::value_error(named(place) + ": a string with half a surrogate pair, which is no text");
}

Json whole_number(const py::handle& value, const std::string& place) {
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!number) throw py::error_already_set();
    int overflow = 0;
    const long long fits = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    if (overflow != 0) throw py::value_error(named(place) + ": a whole number of more than 64 bits");
    return fits;
}

Json real_number(const py::handle& value, const Taking& taking) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred()) throw py::error_already_set();
    if (taking.absent == Absent::null && !std::isfinite(number)) return {};
    return number;
}

Json value_of(const py::handle& value, const std::string& place, int depth, const Taking& taking);

Json array_of(const py::sequence& values, const std::string& place, int depth, const Taking& taking) {
    Json json = Json::array();
    const py::tuple fixed(values);  // what a number of the caller's own does on its conversion cannot change it
    for (std::size_t i = 0; i < fixed.size(); ++i)
        json.push_back(value_of(fixed[i], reading::name_in(place, i), depth + 1, taking));
    return json;
}

Json object_of(const py::dict& dict, const std::string& place, int depth, const Taking& taking) {
    Json json = Json::object();
    const auto items = py::reinterpret_steal<py::list>(PyDict_Items(dict.ptr()));
    for (const py::handle item : items) {
        const py::tuple pair = py::reinterpret_borrow<py::tuple>(item);
        const py::handle key = pair[0];
        if (!PyUnicode_Check(key.ptr()))
            throw py::type_error(named(place) + ": the key " +
                                 reading::printable(py::repr(key).cast<std::string>(), 100) + " is not a string");
        const std::string name = string_of(key, place);
        json[name] = value_of(pair[1], reading::name_in(place, name), depth + 1, taking);
    }
    return json;
}

Json numpy_array(const py::handle& array, const std::string& place, int depth, const Taking& taking) {
    const py::object list = array.attr("tolist")();
    if (py::isinstance<py::list>(list)) return array_of(list, place, depth, taking);
    return value_of(list, place, depth + 1, taking);
}

/// One that is not a number of Python's too, as float64 is.
Json numpy_scalar(const py::handle& scalar, const std::string& place, const Taking& taking) {
    switch (py::cast<char>(scalar.attr("dtype").attr("kind"))) {
        case 'b': return PyObject_IsTrue(scalar.ptr()) == 1;
        case 'i':
        case 'u': return whole_number(scalar, place);
        case 'f': return real_number(scalar, taking);
        default: refuse_type(scalar, place);
    }
}

Json value_of(const py::handle& value, const std::string& place, int depth, const Taking& taking) {
    if (depth > deepest) throw py::value_error(fmt::format("{}: nested more than {} deep", place, deepest));
    PyObject* const object = value.ptr();
    if (value.is_none() && taking.absent == Absent::null) return {};
    if (PyBool_Check(object)) return object == Py_True;
    if (PyDict_Check(object)) return object_of(py::reinterpret_borrow<py::dict>(value), place, depth, taking);
    if (PyList_Check(object) || PyTuple_Check(object))
        return array_of(py::reinterpret_borrow<py::sequence>(value), place, depth, taking);
    if (PyUnicode_Check(object)) return string_of(value, place);
    try {
        if (PyFloat_Check(object)) return real_number(value, taking);
        if (py::isinstance<py::array>(value)) return numpy_array(value, place, depth, taking);
        if (py::isinstance(value, taking.numpy_scalar)) return numpy_scalar(value, place, taking);
        if (PyIndex_Check(object)) return whole_number(value, place);
    } catch (py::error_already_set& error) {
        refuse_value(error, place);
    }
    refuse_type(value, place);
}

bool is_number_or_null(const Json& json) { return json.is_number() || json.is_null(); }

bool is_row(const Json& json) {
    return json.is_array() && !json.empty() && std::all_of(json.begin(), json.end(), is_number_or_null);
}

/// Whether a list is a table of numbers: rows of one length.
bool is_table(const Json& json) {
    return !json.empty() && std::all_of(json.begin(), json.end(), [&](const Json& row) {
        return is_row(row) && row.size() == json.front().size();
    });
}

double number_or_nan(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

py::object row_array(const Json& row) {
    py::array_t<double> array(static_cast<py::ssize_t>(row.size()));
    std::transform(row.begin(), row.end(), array.mutable_data(), number_or_nan);
    return array;
}

py::object table_array(const Json& table) {
    py::array_t<double> array({table.size(), table.front().size()});
    double* to = array.mutable_data();
    for (const Json& row : table)
        to = std::transform(row.begin(), row.end(), to, number_or_nan);
    return array;
}

py::object list_of(const Json& json, Lists lists) {
    if (lists == Lists::arrays && is_row(json)) return row_array(json);
    if (lists == Lists::arrays && is_table(json)) return table_array(json);
    py::list list;
    for (const Json& one : json)
        list.append(python_of(one, lists));
    return list;
}

py::object dict_of(const Json& json, Lists lists) {
    py::dict dict;
    for (const auto& [key, value] : json.items())
        dict[text_of(key)] = python_of(value, lists);
    return dict;
}

}  // namespace

py::str text_of(std::string_view text) {
    return py::reinterpret_steal<py::str>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

Json json_of(const py::dict& dict, Absent absent) {
    return object_of(dict, "", 0, {absent, py::module_::import("numpy").attr("generic")});
}

py::object python_of(const Json& json, Lists lists) {
    switch (json.type()) {
        case Json::value_t::object: return dict_of(json, lists);
        case Json::value_t::array: return list_of(json, lists);
        case Json::value_t::string: return text_of(json.get_ref<const std::string&>());
        case Json::value_t::boolean: return py::bool_(json.get<bool>());
        case Json::value_t::number_integer: return py::int_(json.get<std::int64_t>());
        case Json::value_t::number_unsigned: return py::int_(json.get<std::uint64_t>());
        case Json::value_t::number_float: return py::float_(json.get<double>());
        default: return py::none();
    }
}

}  // namespace mechwright::python
