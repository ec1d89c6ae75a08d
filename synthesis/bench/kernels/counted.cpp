#include "synthesis/bench/kernels/counted.h"

namespace mechwright::bench {

namespace {

void count(Operations::Kind kind, OperationMix& mix) {
    switch (kind) {
        case Operations::Kind::variable: break;
        case Operations::Kind::sum:
        case Operations::Kind::difference:
        case Operations::Kind::product: ++mix.sums_and_products; break;
        case Operations::Kind::quotient: ++mix.quotients; break;
        case Operations::Kind::root: ++mix.roots; break;
        case Operations::Kind::sine:
        case Operations::Kind::cosine: ++mix.sines; break;
        case Operations::Kind::angle: ++mix.angles; break;
    }
}

}  // namespace

OperationMix Operations::mix(const std::vector<int>& results) const {
    std::vector<bool> needed(nodes.size());
    const auto need = [&](int node) {
        if (node != constant) needed[static_cast<std::size_t>(node)] = true;
    };
    for (const int node : results)
        need(node);
    for (const int node : looked_at)
        need(node);
    OperationMix counted;
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (!needed[i]) continue;
        count(nodes[i].kind, counted);
        need(nodes[i].a);
        need(nodes[i].b);
    }
    return counted;
}

}  // namespace mechwright::bench
