#include "completion.h"

#include <functional>
#include <vector>

#include "verb_words.h"

namespace facenav::app {
namespace {

/// Text between single quotes of a shell.
std::string inQuotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? std::string("'\\''") : c == '\n' ? std::string(" ") : std::string(1, c);
  return out + "'";
}

/// Calls `visit` for the program and for each verb, with its words: "facenav rig new".
void forEachVerb(const NamedVerb& named, const std::function<void(const NamedVerb&)>& visit) {
  visit(named);
  for (const CLI::App* below : verbsBelow(*named.verb))
    forEachVerb({below, named.words + " " + below->get_name()}, visit);
}

/// "--output", "-o": the words that give the option.
std::vector<std::string> wordsOf(const CLI::Option& option) {
  std::vector<std::string> words;
  for (const auto& name : option.get_lnames()) words.push_back("--" + name);
  for (const auto& name : option.get_snames()) words.push_back("-" + name);
  return words;
}

std::vector<const CLI::Option*> optionsOf(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

/// The fixed values of an option, "scalp cortex", from its type "TEXT:{scalp,cortex}"; empty: any.
std::string valuesOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  std::string values = type.substr(begin + 1, end - begin - 1);
  for (char& c : values)
    if (c == ',') c = ' ';
  return values;
}

/// The lines of a shell's `case` that follow the typed verbs: "'facenav rig new') place=...".
std::string casesOfPlaces(const CLI::App& program) {
  std::string cases;
  forEachVerb({&program, program.get_name()}, [&](const NamedVerb& named) {
    if (named.verb != &program) cases += (cases.empty() ? "" : "|") + inQuotes(named.words);
  });
  return "      " + cases + ") place=\"$place $word\" ;;\n";
}

std::string casesOfValues(const CLI::App& program, const std::string& variable) {
  std::string cases;
  forEachVerb({&program, program.get_name()}, [&](const NamedVerb& named) {
    for (const CLI::Option* option : optionsOf(*named.verb)) {
      const std::string values = valuesOf(*option);
      std::string words;
      for (const auto& word : wordsOf(*option))
        words += (words.empty() ? "" : "|") + inQuotes(named.words + " " + word);
      if (!values.empty()) cases += "    " + words + ") " + variable + "=" + inQuotes(values) + " ;;\n";
    }
  });
  return cases;
}

/// "prepare:a T1 becomes a case", as zsh describes a word.
std::string described(const std::string& word, const std::string& description) {
  return inQuotes(word + ":" + description.substr(0, description.find('\n')));
}

}  // namespace

std::string bashCompletion(const CLI::App& program) {
  std::string verbs, options;
  forEachVerb({&program, program.get_name()}, [&](const NamedVerb& named) {
    std::string below, words;
    for (const CLI::App* verb : verbsBelow(*named.verb))
      below += (below.empty() ? "" : " ") + verb->get_name();
    for (const CLI::Option* option : optionsOf(*named.verb))
      for (const auto& word : wordsOf(*option)) words += (words.empty() ? "" : " ") + word;
    const std::string at = "    " + inQuotes(named.words) + ") ";
    if (!below.empty()) verbs += at + "list=" + inQuotes(below) + " ;;\n";
    options += at + "list=" + inQuotes(words) + " ;;\n";
  });
  return "# Completion of facenav for bash: source <(facenav help --completion bash)\n"
         "_facenav() {\n"
         "  local place=facenav list='' word current=${COMP_WORDS[COMP_CWORD]} "
         "before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \"$place $word\" in\n" +
         casesOfPlaces(program) +
         "    esac\n"
         "  done\n"
         "  case \"$place $before\" in\n" +
         casesOfValues(program, "list") +
         "  esac\n"
         "  if [[ -z $list && $current == -* ]]; then\n"
         "    case \"$place\" in\n" +
         options +
         "    esac\n"
         "  elif [[ -z $list ]]; then\n"
         "    case \"$place\" in\n" +
         verbs +
         "    esac\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$list\" -- \"$current\"))\n"
         "}\n"
         "complete -o default -F _facenav facenav\n";
}

std::string zshCompletion(const CLI::App& program) {
  std::string verbs, options;
  forEachVerb({&program, program.get_name()}, [&](const NamedVerb& named) {
    std::string below, words;
    for (const CLI::App* verb : verbsBelow(*named.verb))
      below += " " + described(verb->get_name(), verb->get_description());
    for (const CLI::Option* option : optionsOf(*named.verb))
      for (const auto& word : wordsOf(*option)) words += " " + described(word, option->get_description());
    const std::string at = "    " + inQuotes(named.words) + ") list=(";
    if (!below.empty()) verbs += at + below + " ) ;;\n";
    options += at + words + " ) ;;\n";
  });
  return "#compdef facenav\n"
         "# Completion of facenav for zsh: source <(facenav help --completion zsh), or a file _facenav in "
         "$fpath\n"
         "_facenav() {\n"
         "  local place=facenav word values=''\n"
         "  local -a list\n"
         "  for word in ${words[2,CURRENT-1]}; do\n"
         "    case \"$place $word\" in\n" +
         casesOfPlaces(program) +
         "    esac\n"
         "  done\n"
         "  case \"$place ${words[CURRENT-1]}\" in\n" +
         casesOfValues(program, "values") +
         "  esac\n"
         "  if [[ -n $values ]]; then\n"
         "    compadd -- ${=values}\n"
         "    return\n"
         "  fi\n"
         "  if [[ ${words[CURRENT]} == -* ]]; then\n"
         "    case \"$place\" in\n" +
         options +
         "    esac\n"
         "    _describe -o option list\n"
         "    return\n"
         "  fi\n"
         "  case \"$place\" in\n" +
         verbs +
         "  esac\n"
         "  if (( $#list )); then _describe verb list; else _files; fi\n"
         "}\n"
         "if [[ ${funcstack[1]} == _facenav ]]; then _facenav \"$@\"; else compdef _facenav facenav; fi\n";
}

}  // namespace facenav::app
