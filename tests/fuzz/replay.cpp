/// \file
/// The fuzz target over its corpus, cut, spliced and with flipped bits: always the same inputs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "synthesis/problem/reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace mechwright::test {

namespace {

struct Sample {
    std::string name;
    std::string bytes;
};

std::vector<Sample> corpus() {
    std::vector<Sample> samples;
    for (const auto& entry : std::filesystem::directory_iterator(MECHWRIGHT_SOURCE_DIR "/tests/fuzz/corpus/problem")) {
        std::ifstream stream(entry.path(), std::ios::binary);
        samples.push_back({entry.path().filename().string(), {std::istreambuf_iterator<char>(stream), {}}});
    }
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.name < b.name; });
    return samples;
}

/// Samples small enough to be changed thousands of times.
std::vector<Sample> small_samples() {
    constexpr std::size_t most_bytes = 4000;
    std::vector<Sample> samples = corpus();
    std::erase_if(samples,
                  [](const Sample& sample) { return sample.bytes.size() > most_bytes || sample.bytes.empty(); });
    return samples;
}

void run(const std::string& bytes) {
    // A copy of exactly this size, so that a sanitizer sees a step beyond its end.
    const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
    LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

/// Distributions differ between libraries; the bits of this engine do not.
std::size_t below(std::mt19937_64& random, std::size_t count) { return static_cast<std::size_t>(random() % count); }

std::string with_flipped_bits(std::string bytes, std::mt19937_64& random) {
    for (std::size_t flips = 1 + below(random, 4); flips > 0; --flips) {
        char& byte = bytes[below(random, bytes.size())];
        byte = static_cast<char>(byte ^ (1 << below(random, 8)));
    }
    return bytes;
}

std::string spliced(const std::string& head, const std::string& tail, std::mt19937_64& random) {
    return head.substr(0, below(random, head.size() + 1)) + tail.substr(below(random, tail.size() + 1));
}

/// A token that matters to the reader, in the place of some bytes.
std::string with_token(std::string bytes, std::mt19937_64& random) {
    static const std::vector<std::string> tokens{"nan",
                                                 "-inf",
                                                 "1e308",
                                                 "1e400",
                                                 "-0.0",
                                                 "[",
                                                 "]",
                                                 "[[",
                                                 "]]",
                                                 "{",
                                                 "}",
                                                 "\"",
                                                 "'''",
                                                 "\"\"\"",
                                                 "=",
                                                 ".",
                                                 ",",
                                                 "#",
                                                 "\n",
                                                 "\r\n",
                                                 "\\u0000",
                                                 "\xFF",
                                                 "min",
                                                 "max",
                                                 "equal",
                                                 "start",
                                                 "points",
                                                 "closed",
                                                 "true",
                                                 "1_000",
                                                 "0x7f",
                                                 "1979-05-27",
                                                 "[path]\n",
                                                 "[[require]]\n",
                                                 "[objective]\n",
                                                 "timing = \"prescribed\"\n",
                                                 "crank_angles = [0, 1]\n"};
    const std::size_t at = below(random, bytes.size());
    return bytes.replace(at, below(random, 6), tokens[below(random, tokens.size())]);
}

}  // namespace

TEST(Replay, TheCorpusIsThereAndHoldsValidProblems) {
    std::size_t valid = 0;
    for (const Sample& sample : corpus()) {
        if (!sample.name.starts_with("valid")) continue;
        ++valid;
        const ReadProblem problem = parse_problem(sample.bytes, "p.toml");
        EXPECT_TRUE(problem.ok()) << sample.name << ": " << to_string(problem.messages.at(0));
    }
    EXPECT_GE(valid, 5u);
}

TEST(Replay, EveryFileOfTheCorpusKeepsTheInvariants) {
    for (const Sample& sample : corpus()) {
        SCOPED_TRACE(sample.name);
        run(sample.bytes);
    }
}

TEST(Replay, EveryTruncationOfAValidProblemKeepsTheInvariants) {
    for (const Sample& sample : small_samples()) {
        if (!sample.name.starts_with("valid")) continue;
        for (std::size_t length = 0; length < sample.bytes.size(); ++length)
            run(sample.bytes.substr(0, length));
    }
}

TEST(Replay, FlippedBitsKeepTheInvariants) {
    const std::vector<Sample> samples = small_samples();
    std::mt19937_64 random(1);
    for (int i = 0; i < 4000; ++i)
        run(with_flipped_bits(samples[below(random, samples.size())].bytes, random));
}

TEST(Replay, SplicesKeepTheInvariants) {
    const std::vector<Sample> samples = small_samples();
    std::mt19937_64 random(2);
    for (int i = 0; i < 4000; ++i)
        run(spliced(samples[below(random, samples.size())].bytes, samples[below(random, samples.size())].bytes,
                    random));
}

TEST(Replay, StrayTokensKeepTheInvariants) {
    const std::vector<Sample> samples = small_samples();
    std::mt19937_64 random(3);
    for (int i = 0; i < 4000; ++i) {
        std::string bytes = samples[below(random, samples.size())].bytes;
        for (std::size_t changes = 1 + below(random, 3); changes > 0 && !bytes.empty(); --changes)
            bytes = with_token(std::move(bytes), random);
        run(bytes);
    }
}

}  // namespace mechwright::test
