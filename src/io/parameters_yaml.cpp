#include "io/parameters_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

#include "io/nearest_name.hpp"

namespace stillmap {
namespace {

constexpr char kPresetKey[] = "preset";

const char* type_name(double) {
  return "a number";
}
const char* type_name(int) {
  return "a whole number";
}
const char* type_name(bool) {
  return "true or false";
}
const char* type_name(const std::string&) {
  return "a word";
}
const char* type_name(const std::vector<double>&) {
  return "a number or a list of numbers";
}

std::string text_of(const YAML::Node& node) {
  YAML::Emitter emitter;
  emitter << YAML::Flow << node;
  return emitter.c_str();
}

template <class T>
T convert(const YAML::Node& node) {
  return node.as<T>();
}
template <>
std::string convert(const YAML::Node& node) {
  return node.IsNull() ? std::string() : node.as<std::string>();
}
template <>
std::vector<double> convert(const YAML::Node& node) {
  if (node.IsScalar()) return {node.as<double>()};
  return node.as<std::vector<double>>();
}

[[noreturn]] void refuse_unknown(const std::string& where, const std::string& name) {
  const std::string nearest = nearest_name(name, parameter_names());
  throw std::runtime_error(where + name + ": unknown parameter; " +
                           (nearest.empty() ? std::string("`stillmap parameters` lists them all")
                                            : "did you mean " + nearest + "?"));
}

/// `where` is "file.yaml:12: " or empty.
void set_from_node(Parameters& parameters, const std::string& name, const YAML::Node& node,
                   const std::string& where) {
  bool found = false;
  visit_parameters(parameters, [&](const ParameterInfo& info, auto& value) {
    if (name != info.name) return;
    found = true;
    try {
      value = convert<std::decay_t<decltype(value)>>(node);
    } catch (const YAML::Exception&) {
      throw std::runtime_error(where + name + ": '" + text_of(node) + "' is not " + type_name(value));
    }
  });
  if (!found) refuse_unknown(where, name);
}

YAML::Node load_map(const std::string& file) {
  const std::string unreadable = file + ": cannot be read; expected a YAML file of parameters";
  if (std::filesystem::is_directory(file)) throw std::runtime_error(unreadable);
  try {
    const YAML::Node root = YAML::LoadFile(file);
    if (root.IsNull() || root.IsMap()) return root;
  } catch (const YAML::BadFile&) {
    throw std::runtime_error(unreadable);
  } catch (const YAML::ParserException& error) {
    throw std::runtime_error(file + ": not YAML: " + error.what());
  }
  throw std::runtime_error(file + ": expected lines of 'name: value'");
}

Parameters base_of(const YAML::Node& root, const std::string& file) {
  const YAML::Node name = root.IsMap() ? root[kPresetKey] : YAML::Node();
  if (!name.IsDefined() || name.IsNull()) return Parameters();
  if (!name.IsScalar()) throw std::runtime_error(file + ": preset: '" + text_of(name) + "' is not a word");
  try {
    return preset(name.as<std::string>());
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

/// The shortest text that reads back as the same number, with a point: some readers of YAML keep types apart.
std::string to_text(double value) {
  for (int digits = 6;; ++digits) {
    std::ostringstream text;
    text.precision(digits);
    text << value;
    const std::string word = text.str();
    if (std::stod(word) != value && digits < 17) continue;
    return word.find_first_of(".e") == std::string::npos ? word + ".0" : word;
  }
}
std::string to_text(int value) {
  return std::to_string(value);
}
std::string to_text(bool value) {
  return value ? "true" : "false";
}
std::string to_text(const std::string& value) {
  const bool is_plain =
      value.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./") ==
      std::string::npos;
  if (is_plain && YAML::Load(value).IsScalar()) return value;  // "null" is none
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << value;
  return emitter.c_str();
}
std::string to_text(const std::vector<double>& values) {
  std::string text = "[";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + to_text(value);
  return text + "]";
}

/// Comment lines of at most 100 characters.
std::string wrapped_comment(const std::string& text) {
  std::istringstream words(text);
  std::string lines, line = "#";
  for (std::string word; words >> word; line += " " + word)
    if (line.size() + 1 + word.size() > 100) {
      lines += line + "\n";
      line = "#";
    }
  return lines + line + "\n";
}

std::string comment_of(const ParameterInfo& info, bool is_number) {
  std::ostringstream text;
  text << info.help;
  if (*info.options) text << " [" << info.options << "]";
  if (is_number)
    text << " [" << info.min << " to " << info.max << (*info.unit ? " " : "") << info.unit << "]";
  return wrapped_comment(text.str());
}

}  // namespace

Parameters load_parameters(const std::string& yaml_file) {
  const YAML::Node root = load_map(yaml_file);
  Parameters parameters = base_of(root, yaml_file);
  std::set<std::string> seen;
  for (const auto& entry : root) {
    const std::string where = yaml_file + ":" + std::to_string(entry.first.Mark().line + 1) + ": ";
    if (!entry.first.IsScalar())
      throw std::runtime_error(where + "'" + text_of(entry.first) + "' is not the name of a parameter");
    const std::string name = entry.first.as<std::string>();
    if (!seen.insert(name).second) throw std::runtime_error(where + name + ": given twice; keep one");
    if (name != kPresetKey) set_from_node(parameters, name, entry.second, where);
  }
  check_parameters(parameters, yaml_file);
  return parameters;
}

void set_parameter(Parameters& parameters, const std::string& name, const std::string& yaml_text) {
  try {
    set_from_node(parameters, name, YAML::Load(yaml_text), "");
  } catch (const YAML::ParserException&) {
    throw std::runtime_error(name + ": '" + yaml_text + "' is not a value in YAML");
  }
}

void check_parameters(const Parameters& parameters, const std::string& source) {
  const std::vector<std::string> found = problems(parameters);
  if (found.empty()) return;
  std::string message = source + ": ";
  for (const std::string& problem : found) message += (&problem == &found.front() ? "" : "; ") + problem;
  throw std::runtime_error(message);
}

std::string to_yaml(const Parameters& parameters) {
  std::string text =
      "# Parameters of stillmap, as `stillmap parameters` prints them. A file may give only some of them;\n"
      "# `preset: default` or `preset: paper` names the base for the others.\n";
  visit_parameters(parameters, [&](const ParameterInfo& info, const auto& value) {
    using T = std::decay_t<decltype(value)>;
    const bool is_number = !std::is_same_v<T, bool> && !std::is_same_v<T, std::string>;
    text += "\n" + comment_of(info, is_number) + info.name + ": " + to_text(value) + "\n";
  });
  return text;
}

}  // namespace stillmap
