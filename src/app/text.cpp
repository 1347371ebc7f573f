#include "app/text.hpp"

#include <array>

namespace app {
namespace {

struct Entry {
  Text text;
  std::array<std::string_view, 2> in;  ///< by Language
};

constexpr std::array<Entry, static_cast<std::size_t>(Text::count)> entries{{
    {Text::product, {"Angry Balls", "Angry Balls"}},
    {Text::tagline,
     {"Thirty-six reds, one furious cue ball", "Trente-six rouges, une blanche furieuse"}},
    {Text::title_screen, {"title screen", "écran titre"}},
    {Text::billiards, {"Billiards", "Billard"}},
    {Text::quit, {"Quit", "Quitter"}},
    {Text::player, {"Player {0}", "Joueur {0}"}},
    {Text::to_play, {"To play", "À jouer"}},
    {Text::waiting, {"Waiting", "En attente"}},
    {Text::balls_left, {"Balls left", "Boules"}},
    {Text::this_turn, {"This turn", "Ce tour"}},
    {Text::restart, {"Restart", "Recommencer"}},
    {Text::close, {"Close", "Fermer"}},
    {Text::hint_take_cue_ball,
     {"Click the white cue ball to aim.", "Cliquez sur la boule blanche pour viser."}},
    {Text::hint_not_cue_ball,
     {"That is not the cue ball: click the white one first.",
      "Ce n’est pas la boule blanche : cliquez d’abord sur elle."}},
    {Text::hint_shoot,
     {"Click where to send it. Esc or right click: take it back.",
      "Cliquez où l’envoyer. Échap ou clic droit : annuler."}},
    {Text::hint_too_weak,
     {"Too weak to move the ball: click further away.",
      "Trop faible pour la boule : cliquez plus loin."}},
    {Text::hint_watch, {"The balls are rolling…", "Les boules roulent…"}},
    {Text::hint_place,
     {"Click to put the cue ball down here.", "Cliquez pour poser la boule blanche ici."}},
    {Text::hint_obstructed, {"It cannot lie here: {0}.", "Elle ne peut pas être ici : {0}."}},
    {Text::on_ball, {"another ball is in the way", "une autre boule gêne"}},
    {Text::on_hole, {"over a pocket", "au-dessus d’un trou"}},
    {Text::on_cushion, {"off the table", "hors de la table"}},
    {Text::speed, {"{0} px/s", "{0} px/s"}},
    {Text::speed_capped, {"{0} px/s · max", "{0} px/s · max"}},
    {Text::points, {"+{0}", "+{0}"}},
    {Text::turn_of, {"{0} to play", "{0}, à vous de jouer"}},
    {Text::turn_scored, {"{0} made {1} points", "{0} a marqué {1} points"}},
    {Text::turn_nothing, {"{0} made no points", "{0} n’a rien marqué"}},
    {Text::cue_ball_in_hand,
     {"Cue ball pocketed: {0} puts it anywhere", "Boule blanche tombée : {0} la replace"}},
    {Text::wins, {"{0} wins!", "{0} gagne !"}},
    {Text::draw, {"It’s a draw", "Match nul"}},
    {Text::play_again, {"Play again", "Rejouer"}},
    {Text::back_to_title, {"Back to title", "Retour au titre"}},
    {Text::ask_restart, {"Start again?", "Recommencer ?"}},
    {Text::ask_leave, {"Leave the table?", "Quitter la table ?"}},
    {Text::game_is_lost, {"This game will be lost.", "Cette partie sera perdue."}},
    {Text::new_game, {"New game", "Nouvelle partie"}},
    {Text::leave, {"Leave", "Quitter"}},
    {Text::keep_playing, {"Keep playing", "Continuer"}},
    {Text::aiming, {"{0} aims", "{0} vise"}},
    {Text::watching, {"{0} watches the shot", "{0} regarde son tir"}},
    {Text::placing, {"{0} places the cue ball", "{0} place la boule blanche"}},
    {Text::state,
     {"{0} · {1} · Player 1: {2} · Player 2: {3} · balls left: {4}",
      "{0} · {1} · Joueur 1 : {2} · Joueur 2 : {3} · boules restantes : {4}"}},
}};

static_assert(
    [] {
      for (std::size_t i = 0; i < entries.size(); ++i)
        if (static_cast<std::size_t>(entries[i].text) != i) return false;
      return true;
    }(),
    "the table must list the texts in the order of the enumeration");

}  // namespace

Language language_of_locale(std::string_view locale) {
  return locale.starts_with("fr") ? Language::french : Language::english;
}

std::string Words::operator()(Text text, std::initializer_list<std::string_view> values) const {
  const std::string_view pattern =
      entries[static_cast<std::size_t>(text)].in[static_cast<std::size_t>(language_)];
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '{') {
      out += values.begin()[pattern[i + 1] - '0'];
      i += 2;
    } else {
      out += pattern[i];
    }
  }
  return out;
}

std::string Words::number(int value) const {
  const std::string_view separator = language_ == Language::french ? "\u202f" : ",";
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3 && digits[at - 4] != '-';) {
    at -= 3;
    digits.insert(at, separator);
  }
  return digits;
}

std::string Words::player(int player) const { return (*this)(Text::player, {number(player + 1)}); }

}  // namespace app
