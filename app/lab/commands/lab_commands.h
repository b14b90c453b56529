#pragma once
// The laboratory's verbs, one function each, as in commands/commands.h.

#include "commands/commands.h"

namespace facenav::app {

void addSimulate(CLI::App& app, Context& context);
void addEvaluate(CLI::App& app, Context& context);
/// Adds `facenav evaluate prepare` below evaluate.
void addEvaluatePrepare(CLI::App& evaluate, Context& context);
/// Adds `facenav evaluate rigs` below evaluate.
void addEvaluateRigs(CLI::App& evaluate, Context& context);
/// Adds `facenav evaluate gates` below evaluate.
void addEvaluateGates(CLI::App& evaluate, Context& context);
void addEvaluateSkin(CLI::App& evaluate, Context& context);
/// Adds `facenav evaluate return` below evaluate.
void addEvaluateReturn(CLI::App& evaluate, Context& context);
void addEvaluatePairs(CLI::App& evaluate, Context& context);
void addDemo(CLI::App& app, Context& context);

}  // namespace facenav::app
