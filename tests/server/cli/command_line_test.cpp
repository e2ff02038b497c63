// SPDX-License-Identifier: Apache-2.0
#include "server/cli/command_line.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

std::variant<Command, UsageMessage> read(const std::vector<const char*>& arguments) {
    return read_command_line(arguments);
}

template <class Options>
Options options(const std::vector<const char*>& arguments) {
    const auto line = read(arguments);
    const auto* command = std::get_if<Command>(&line);
    if (command == nullptr || !std::holds_alternative<Options>(*command)) {
        ADD_FAILURE() << "another command, or none";
        return {};
    }
    return std::get<Options>(*command);
}

TEST(CommandLine, ServeListensToThisMachineOnlyByDefault) {
    const auto serve = options<ServeOptions>({"serve"});
    EXPECT_EQ(serve.listen, "127.0.0.1:8080");
    EXPECT_FALSE(serve.allow_remote);
}

TEST(CommandLine, ReadsServe) {
    const auto serve = options<ServeOptions>({"serve",
                                              "--listen",
                                              "0.0.0.0:0",
                                              "--allow-remote",
                                              "--data",
                                              "d",
                                              "--assets",
                                              "a",
                                              "--threads",
                                              "3",
                                              "--queue",
                                              "7",
                                              "--max-seconds",
                                              "90.5",
                                              "--cors-origin",
                                              "https://a.example",
                                              "--drain-delay",
                                              "15",
                                              "--allowed-host",
                                              "render.example",
                                              "--allowed-host",
                                              "[::1]:80",
                                              "--max-connections",
                                              "500",
                                              "--max-connections-per-address",
                                              "50",
                                              "--health-listen",
                                              "127.0.0.1:9"});
    EXPECT_EQ(serve.listen, "0.0.0.0:0");
    EXPECT_TRUE(serve.allow_remote);
    EXPECT_EQ(serve.data, "d");
    EXPECT_EQ(serve.assets, "a");
    EXPECT_EQ(serve.threads, 3);
    EXPECT_EQ(serve.queue, 7U);
    EXPECT_EQ(serve.max_seconds, 90.5);
    EXPECT_EQ(serve.cors_origins, std::vector<std::string>{"https://a.example"});
    EXPECT_EQ(serve.drain_delay_s, 15);
    EXPECT_EQ(serve.allowed_hosts, (std::vector<std::string>{"render.example", "[::1]:80"}));
    EXPECT_EQ(serve.max_connections, 500U);
    EXPECT_EQ(serve.max_connections_per_address, 50U);
    EXPECT_EQ(serve.health_listen, "127.0.0.1:9");
}

TEST(CommandLine, ReadsRender) {
    const auto render = options<RenderOptions>({"render",
                                                "-o",
                                                "a.png",
                                                "s.json",
                                                "-o",
                                                "b.exr",
                                                "--integrator",
                                                "rgb",
                                                "--samples",
                                                "9",
                                                "--seconds",
                                                "1.5",
                                                "--error",
                                                "0.01",
                                                "--seed",
                                                "5",
                                                "--display",
                                                "srgb",
                                                "--exposure",
                                                "2",
                                                "--color-space",
                                                "xyz",
                                                "--resolution",
                                                "64x48",
                                                "--wavelength-step",
                                                "10",
                                                "--max-depth",
                                                "3",
                                                "--report",
                                                "r.json"});
    EXPECT_EQ(render.document, "s.json");
    EXPECT_EQ(render.outputs, (std::vector<std::filesystem::path>{"a.png", "b.exr"}));
    EXPECT_EQ(render.report, "r.json");
    EXPECT_EQ(render.overrides.integrator, "rgb");
    EXPECT_EQ(render.overrides.samples, 9U);
    EXPECT_EQ(render.overrides.seconds, 1.5);
    EXPECT_EQ(render.overrides.error, 0.01);
    EXPECT_EQ(render.overrides.seed, 5U);
    EXPECT_EQ(render.overrides.output.at("exposure"), "2");
    EXPECT_EQ(render.overrides.output.at("color_space"), "xyz");
    EXPECT_EQ(render.overrides.resolution, "64x48");
    EXPECT_EQ(render.overrides.wavelength_step, 10);
    EXPECT_EQ(render.overrides.max_depth, 3);
}

TEST(CommandLine, WhatIsNotSaidIsNotOverridden) {
    EXPECT_EQ(options<RenderOptions>({"render", "s.json", "-o", "a.png"}).overrides, Overrides{});
}

TEST(CommandLine, ReadsTheOthers) {
    EXPECT_EQ(options<ValidateOptions>({"validate", "s.json"}).document, "s.json");
    EXPECT_TRUE(options<PlanOptions>({"plan", "s.json", "--json"}).json);
    const auto compare = options<CompareOptions>(
        {"compare", "a.exr", "b.png", "-o", "m.png", "--json", "--white", "A", "--exposure", "2"});
    EXPECT_EQ(compare.a, "a.exr");
    EXPECT_EQ(compare.b, "b.png");
    EXPECT_EQ(compare.map, "m.png");
    EXPECT_TRUE(compare.json);
    EXPECT_EQ(compare.output, (api::OutputTexts{{"exposure", "2"}, {"white", "A"}}));
    (void)options<VersionOptions>({"--version"});
}

TEST(CommandLine, BadUsageIsExitCode2) {
    const std::vector<std::vector<const char*>> lines{
        {},
        {"paint"},
        {"render", "s.json"},
        {"render", "-o", "a.png"},
        {"render", "s.json", "-o", "a.png", "--integrator", "bogus"},
        {"render", "s.json", "-o", "a.png", "--samples", "-1"},
        {"render", "s.json", "-o", "a.png", "--samples", "1.5"},
        {"render", "s.json", "-o", "a.png", "--seconds", "nan"},
        {"render", "s.json", "-o", "a.png", "--wavelength-step", "0"},
        {"serve", "--threads", "-1"},
        {"serve", "--allowed-host", "http://a.example"},
        {"serve", "--allowed-host", "*"},
        {"validate"},
        {"compare", "a.exr"},
        {"compare", "a.exr", "b.exr", "--gamut", "clip"},
        {"serve", "validate"},
    };
    for (const auto& line : lines) {
        const auto read_line = read(line);
        const auto* message = std::get_if<UsageMessage>(&read_line);
        ASSERT_NE(message, nullptr) << (line.empty() ? "" : line.back());
        EXPECT_EQ(message->exit_code, kExitBadInput);
        EXPECT_FALSE(message->text.empty());
    }
}

TEST(CommandLine, HelpIsExitCode0) {
    for (const auto& line : std::vector<std::vector<const char*>>{{"--help"}, {"serve", "-h"}}) {
        const auto read_line = read(line);
        const auto* message = std::get_if<UsageMessage>(&read_line);
        ASSERT_NE(message, nullptr);
        EXPECT_EQ(message->exit_code, kExitOk);
    }
}

}  // namespace
}  // namespace bouguer::server
