#include "synthesis/document/kinds_in_documents.h"

#include <algorithm>
#include <array>

#include "synthesis/mechanism/cam/document/cam.h"

namespace mechwright {

std::span<const KindInDocuments> kinds_in_documents() {
    static const std::array all{cam_in_documents()};
    return all;
}

const KindInDocuments* kind_in_documents(const Mechanism& mechanism) {
    const auto all = kinds_in_documents();
    const auto at = std::find_if(all.begin(), all.end(), [&](const auto& k) { return k.mechanism == mechanism.name; });
    return at == all.end() ? nullptr : &*at;
}

}  // namespace mechwright
