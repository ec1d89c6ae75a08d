#pragma once
/// \file
/// The sections of problem files and their keys in words, from the lists that the reader takes them from.

#include <string>
#include <string_view>
#include <vector>

namespace mechwright {

/// The names that `explained_section` knows: sections such as "path", tables in them such as "function.input", and
/// keys such as "timing"; each once.
std::vector<std::string> section_names();

/// What a section is, with its keys; of the name of a key the sections that have it, and what it means there; of
/// "section.key" that key alone. Lines of 80 characters at most; empty where there is no such name.
std::string explained_section(std::string_view name, bool colour);

/// All sections with their keys, as tables in Markdown.
std::string sections_as_markdown();

}  // namespace mechwright
