#include "synthesis/bench/kernels/counted.h"

#include <algorithm>

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

/// Clock cycles from operands to result, about, on processors of these years: enough to say which chain is longest.
int cycles(Operations::Kind kind) {
    switch (kind) {
        case Operations::Kind::variable: return 0;
        case Operations::Kind::sum:
        case Operations::Kind::difference:
        case Operations::Kind::product: return 4;
        case Operations::Kind::quotient: return 14;
        case Operations::Kind::root: return 20;
        case Operations::Kind::sine:
        case Operations::Kind::cosine: return 60;
        case Operations::Kind::angle: return 100;
    }
    return 0;
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

OperationMix Operations::longest_chain(const std::vector<int>& results) const {
    std::vector<int> until(nodes.size());  // cycles until a node is there
    const auto until_there = [&](int node) { return node == constant ? 0 : until[static_cast<std::size_t>(node)]; };
    for (std::size_t i = 0; i < nodes.size(); ++i)
        until[i] = cycles(nodes[i].kind) + std::max(until_there(nodes[i].a), until_there(nodes[i].b));
    const auto later = [&](int a, int b) { return until_there(a) < until_there(b) ? b : a; };
    OperationMix chain;
    int node = constant;
    for (const int result : results)
        node = later(node, result);
    while (node != constant) {
        const Node& n = nodes[static_cast<std::size_t>(node)];
        count(n.kind, chain);
        node = later(n.a, n.b);
    }
    return chain;
}

}  // namespace mechwright::bench
