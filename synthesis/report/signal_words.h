#pragma once
/// \file
/// What can be a signal of a linkage, and what can be made of one, and of rooms and regions, in words.

#include <string>
#include <string_view>

namespace mechwright {

/// What can be made of a signal, for people; lines of 80 characters at most.
std::string words_of_signals();

/// What a quantity of a signal is, such as "swing.speed.greatest(10, 50)", or one of the words, or "signals"; empty
/// where it is none of them.
std::string explained_signal(std::string_view name);

/// What a quantity of a room or a region is, such as "bay.margin"; empty where it is none.
std::string explained_room(std::string_view name);

}  // namespace mechwright
