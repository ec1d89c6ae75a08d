#pragma once
/// \file
/// What came of a point, as a row of the data.

#include "synthesis/study/store.h"

namespace mechwright {

/// How a point was solved.
enum class Start {
    own,        ///< by a search of its own
    neighbour,  ///< from the design of the point before
    both        ///< both ways, and the better design was taken
};

std::string_view name_of(Start start);

/// The row of a point's result. `differed`: of points solved both ways, whether the search of their own was better.
StudyRow row_of(const PreparedStudy& prepared, std::uint64_t point, const Problem& problem, const Result& result,
                Start start, bool differed);

/// The row of a point whose problem cannot be read: its status is "invalid", and the note says why.
StudyRow invalid_row(const PreparedStudy& prepared, std::uint64_t point, const std::string& why);

/// The row of a given design: "evaluated", or "not-assembled".
StudyRow evaluated_row(const PreparedStudy& prepared, std::uint64_t point, const Problem& problem,
                       const Solution& solution);

}  // namespace mechwright
