#include "synthesis/document/search_document.h"

#include <utility>

#include "synthesis/document/fields.h"
#include "synthesis/document/lists.h"
#include "synthesis/document/proof_document.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

Json solutions_of(const SolutionCounts& counts) {
    return {{of_solutions("tracked"), counts.tracked},
            {of_solutions("distinct"), counts.distinct},
            {of_solutions("at_infinity"), counts.at_infinity},
            {of_solutions("singular"), counts.singular},
            {of_solutions("real"), counts.real},
            {of_solutions("certified"), counts.certified},
            {of_solutions("defect_free"), counts.defect_free}};
}

/// Those that there are.
Json sources_of(const StartSources& counts) {
    Json json = Json::object();
    const auto put = [&](std::string_view name, long count) {
        if (count > 0) json[name] = count;
    };
    put(of_start_sources("preferred"), counts.preferred);
    put(of_start_sources("drawn"), counts.drawn);
    put(of_start_sources("four_bars"), counts.four_bars);
    put(of_start_sources("nearby"), counts.nearby);
    return json;
}

}  // namespace

Json search_document(const Problem& problem, const SearchReport& search) {
    Json json{{of_search("method"), search.method}, {of_search("complete"), search.complete()}};
    if (search.proof) {
        json[of_search("argument")] = search.proof->argument;
        json[of_search("certificate")] = certificate_document(problem, search.proof->certificate);
    }
    if (search.drawn > 0) {
        json[of_search("drawn")] = search.drawn;
        json[of_search("assembled")] = search.assembled;
        json[of_search("optimised")] = search.optimised;
        json[of_search("sources")] = sources_of(search.sources);
    }
    json[of_search("starts")] = search.starts;
    json[of_search("local_optima")] = search.local_optima;
    json[of_search("hits")] = search.hits;
    put_number(json, of_search("missed_chance"), search.missed_chance);
    if (search.bound) {
        put_number(json, of_search("bound"), *search.bound);
        if (search.boxes > 0) json[of_search("boxes")] = search.boxes;
    }
    if (search.solutions) json[of_search("solutions")] = solutions_of(*search.solutions);
    if (search.free_numbers > 0) json[of_search("free_numbers")] = search.free_numbers;
    if (search.discrete) {
        Json discrete{{of_discrete("problems"), search.discrete->problems}};
        if (problem.objective) {
            if (search.discrete->continuous)
                put_number(discrete, of_discrete("continuous"), *search.discrete->continuous);
            put_number(discrete, of_discrete("gap"), search.discrete->gap);
        }
        if (search.discrete->combinations > 0) discrete[of_discrete("combinations")] = search.discrete->combinations;
        if (search.discrete->left_out > 0) discrete[of_discrete("left_out")] = search.discrete->left_out;
        json[of_search("discrete")] = std::move(discrete);
    }
    json[of_search("evaluations")] = search.evaluations;
    json[of_search("seed")] = problem.solver.seed;
    put_number(json, of_search("seconds"), search.seconds);
    return json;
}

}  // namespace mechwright
