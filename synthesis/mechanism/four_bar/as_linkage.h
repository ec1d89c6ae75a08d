#pragma once
/// \file
/// The four-bar as the linkage that it is.

#include "synthesis/mechanism/as_linkage.h"

namespace mechwright {

AsLinkage four_bar_as_linkage();

}  // namespace mechwright
