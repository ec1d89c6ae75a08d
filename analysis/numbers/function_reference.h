#pragma once
/// \file
/// A function that is handed on to code which is compiled once for all functions.

#include <memory>
#include <type_traits>
#include <utility>

namespace mechwright {

template <class Signature>
class FunctionReference;

/// Calls a function that stands elsewhere and must outlast it. Neither copies it nor allocates, as std::function does.
template <class Result, class... Arguments>
class FunctionReference<Result(Arguments...)> {
public:
    template <class Function>
    requires(std::is_invocable_r_v<Result, const Function&, Arguments...> &&
             !std::is_same_v<Function, FunctionReference>) FunctionReference(const Function& function)
        : function_(std::addressof(function)), call_([](const void* called, Arguments... arguments) -> Result {
              return (*static_cast<const Function*>(called))(std::forward<Arguments>(arguments)...);
          }) {}

    Result operator()(Arguments... arguments) const { return call_(function_, std::forward<Arguments>(arguments)...); }

private:
    const void* function_;
    Result (*call_)(const void*, Arguments...);
};

}  // namespace mechwright
