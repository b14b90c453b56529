#pragma once
// The person who works at this window: name or initials, asked for once. Sign-off, override, review and plan
// share it; each field that asks shows it, and keeps what was typed there for the others.

#include <QString>
#include <string>

namespace facenav::ui {

/// Name or initials as last given in any field of this window; empty at first.
QString author();
/// Keeps the name for the other fields and the next start. An empty name changes nothing.
void rememberAuthor(const QString& name);
/// Name to record with a change of the plan: author(), else the login name of this computer.
std::string recordedAuthor();

}  // namespace facenav::ui
