#include "app/widgets/level_fault.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace app {
namespace {

/// How the engine begins, and what that is in French. What follows stays, unless `alone`: names,
/// numbers, pieces of the file.
struct Phrase {
  std::string_view english;
  std::string_view french;
  bool alone = false;
};

// The first that fits counts.
constexpr std::array problems{
    Phrase{"is missing", "manque"},
    Phrase{"is an unknown key", "est une clé inconnue"},
    Phrase{"is given twice", "est donné deux fois"},
    Phrase{"is empty", "est vide"},
    Phrase{"is not valid JSON", "n’est pas du JSON valable", true},
    Phrase{"is nested too deeply", "est imbriqué trop profondément"},
    Phrase{"is not in UTF-8", "n’est pas en UTF-8"},
    Phrase{"is not there any more", "n’est plus là"},
    Phrase{"is an object", "est un objet"},
    Phrase{"is an array", "est une liste"},
    Phrase{"is ", "vaut "},
    Phrase{"have no projectile", "n’ont pas de projectile"},
    Phrase{"have no enemy", "n’ont pas d’ennemi"},
    Phrase{"has ", "a trop d’éléments", true},
    Phrase{"moves at ", "va à "},
    Phrase{"sticks out of the solid ", "dépasse d’un bord fermé", true},
    Phrase{"overlaps obstacle ", "chevauche un obstacle", true},
    Phrase{"cannot be opened", "ne s’ouvre pas", true},
};

constexpr std::array expectations{
    Phrase{"a number greater than ", "un nombre supérieur à "},
    Phrase{"a number from ", "un nombre de "},
    Phrase{"a number of at least ", "un nombre d’au moins "},
    Phrase{"a whole number from ", "un nombre entier de "},
    Phrase{"one of ", "l’une de "},
    Phrase{"at most one cue ball or projectile, and that as the first ball",
           "une boule blanche ou un projectile au plus, et en premier"},
    Phrase{"at most ", "au plus "},
};
// What stands further on.
constexpr std::array problem_joints{Phrase{", newer than this program", ", plus récent que le jeu"},
                                    Phrase{", but ball 0 is ", ", mais la boule 0 est déjà "},
                                    Phrase{" already", ""}};
constexpr std::array expected_joints{Phrase{" and at most ", " et d’au plus "},
                                     Phrase{" to ", " à "}};

template <class Phrases>
void join_in_french(std::string& text, const Phrases& joints) {
  for (const Phrase& joint : joints)
    if (const auto at = text.find(joint.english); at != std::string::npos)
      text.replace(at, joint.english.size(), joint.french);
}

/// Whether it could be said in French.
template <class Phrases>
bool say_in_french(std::string& text, const Phrases& phrases) {
  for (const Phrase& phrase : phrases)
    if (text.starts_with(phrase.english)) {
      text.replace(0, phrase.alone ? text.size() : phrase.english.size(), phrase.french);
      return true;
    }
  return false;
}

}  // namespace

std::string problem_of(const Words& words, const Level& level) {
  if (level.scene || words.language() == Language::english) return level.problem;
  carom::Error error = level.scene.errors().front();
  std::string expected = carom::to_string(std::exchange(error.expected, {}));
  std::string problem = carom::to_string(error.problem);
  say_in_french(problem, problems);
  join_in_french(problem, problem_joints);
  error.problem = problem;
  std::string text = carom::to_string(error, level.file);
  // What is not known in French is left out.
  if (!say_in_french(expected, expectations)) return text;
  join_in_french(expected, expected_joints);
  return text + " ; attendu : " + expected;
}

}  // namespace app
