#include "app/text.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace app {
namespace {

struct Entry {
  Text text;
  std::array<std::string_view, 2> in;  ///< by Language
};

constexpr std::array<Entry, static_cast<std::size_t>(Text::count)> entries{{
    {Text::product, {"Angry Balls", "Angry Balls"}},
    {Text::tagline, {"Two games, one furious ball", "Deux jeux, une boule furieuse"}},
    {Text::title_screen, {"title screen", "écran titre"}},
    {Text::billiards, {"Billiards", "Billard"}},
    {Text::angry_balls, {"Angry Balls", "Angry Balls"}},
    {Text::quit, {"Quit", "Quitter"}},
    {Text::player, {"Player {0}", "Joueur {0}"}},
    {Text::to_play, {"To play", "À jouer"}},
    {Text::waiting, {"Waiting", "En attente"}},
    {Text::balls_left, {"Balls left", "Boules"}},
    {Text::this_turn, {"This turn", "Ce tour"}},
    {Text::restart, {"Restart", "Recommencer"}},
    {Text::close, {"Close", "Fermer"}},
    {Text::retry, {"Try again", "Réessayer"}},
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
    {Text::hint_watch,
     {"The balls are rolling… Hold F: faster. P: pause.",
      "Les boules roulent… F maintenue : plus vite. P : pause."}},
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
     {"{0} · {1} · {5}: {2} · {6}: {3} · balls left: {4}",
      "{0} · {1} · {5} : {2} · {6} : {3} · boules restantes : {4}"}},
    {Text::choose_level, {"Choose a level", "Choisissez un niveau"}},
    {Text::level_menu, {"level menu", "choix du niveau"}},
    {Text::best, {"Best: {0}", "Record : {0}"}},
    {Text::not_won_yet, {"Not won yet", "À gagner"}},
    {Text::page, {"Page {0} of {1}", "Page {0} sur {1}"}},
    {Text::previous_page, {"‹ Previous", "‹ Avant"}},
    {Text::next_page, {"Next ›", "Après ›"}},
    {Text::title_button, {"Title", "Titre"}},
    {Text::hint_choose_level,
     {"Break every horned ball, or drive it out.",
      "Brisez ou chassez toutes les boules à cornes."}},
    {Text::hint_broken_level, {"Cannot be played: {0}", "Injouable : {0}"}},
    {Text::scores_set_aside,
     {"The scores could not be read; they are kept as scores.json.broken.",
      "Records illisibles, mis de côté dans scores.json.broken."}},
    {Text::scores_not_kept,
     {"Best scores cannot be saved.", "Les records ne peuvent pas être gardés."}},
    {Text::menu, {"Menu", "Menu"}},
    {Text::score, {"Score", "Score"}},
    {Text::throws, {"Throws", "Lancers"}},
    {Text::enemies, {"Enemies", "Ennemis"}},
    {Text::goal, {"Enemies: {0} · throws: {1}", "Ennemis : {0} · lancers : {1}"}},
    {Text::level_and_name, {"Level {0}: {1}", "Niveau {0} : {1}"}},
    {Text::hint_take_projectile,
     {"Click the angry ball to take it.", "Cliquez sur la boule en colère."}},
    {Text::hint_not_projectile,
     {"Not there: click the angry ball on its post.", "Pas là : cliquez sur la boule en colère."}},
    {Text::hint_throw,
     {"Click where to throw it. Esc or right click: take it back.",
      "Cliquez où la lancer. Échap ou clic droit : annuler."}},
    {Text::hint_flying,
     {"There it goes… Hold F: faster. P: pause.",
      "C’est parti… F maintenue : plus vite. P : pause."}},
    {Text::hint_next,
     {"All is calm. Click anywhere, or press N, for the next throw.",
      "Tout est calme. Cliquez, ou touche N, pour relancer."}},
    {Text::hint_finish,
     {"That was the last throw. Click anywhere, or press N, to end.",
      "C’était le dernier lancer. Cliquez, ou touche N."}},
    {Text::next_throw, {"Next throw (N)", "Lancer suivant (N)"}},
    {Text::finish, {"End of the level (N)", "Fin du niveau (N)"}},
    {Text::won, {"Level won!", "Niveau gagné !"}},
    {Text::lost, {"Level lost", "Niveau perdu"}},
    {Text::new_best, {"A new best score!", "Nouveau record !"}},
    {Text::throws_used, {"Throws used: {0} of {1}", "Lancers : {0} sur {1}"}},
    {Text::enemies_remain, {"Enemies left: {0}", "Ennemis restants : {0}"}},
    {Text::next_level, {"Next level", "Suivant"}},
    {Text::ask_leave_level, {"Leave the level?", "Quitter le niveau ?"}},
    {Text::level_is_lost, {"This try will be lost.", "Cet essai sera perdu."}},
    {Text::ready_to_throw, {"click the angry ball to throw", "cliquez sur la boule pour lancer"}},
    {Text::watching_throw, {"watching the throw", "le lancer est en cours"}},
    {Text::next_offered, {"click for the next throw", "cliquez pour le lancer suivant"}},
    {Text::finish_offered, {"click to end the level", "cliquez pour finir le niveau"}},
    {Text::level_state,
     {"{0} · {1} · {2} · score: {3} · throws left: {4} · enemies left: {5}",
      "{0} · {1} · {2} · score : {3} · lancers restants : {4} · ennemis restants : {5}"}},
    {Text::menu_state, {"{0} · {1} · levels: {2}", "{0} · {1} · niveaux : {2}"}},
    {Text::continue_billiards,
     {"Continue: billiards, player {0}", "Reprendre : billard, joueur {0}"}},
    {Text::continue_table, {"Continue: billiards", "Reprendre : billard"}},
    {Text::continue_level, {"Continue: level {0}", "Reprendre : niveau {0}"}},
    {Text::continue_named_level, {"Continue: {0}", "Reprendre : {0}"}},
    {Text::practice, {"Practice", "S’exercer"}},
    {Text::replays, {"Replays", "Revoir"}},
    {Text::ask_new_game, {"Give up the game kept?", "Abandonner la partie ?"}},
    {Text::continue_game, {"Continue it", "La reprendre"}},
    {Text::kept_billiards, {"Player 1: {0} · Player 2: {1}", "Joueur 1 : {0} · Joueur 2 : {1}"}},
    {Text::other_level, {"Other level", "Autre niveau"}},
    {Text::kept_refused_billiards, {"Billiards: not continued", "Billard : pas de reprise"}},
    {Text::kept_refused_level, {"Level: not continued", "Niveau : pas de reprise"}},
    {Text::kept_set_aside, {"It is kept under another name:", "Elle est mise de côté sous le nom"}},
    {Text::kept_file, {"{0}.broken", "{0}.broken"}},
    {Text::kept_blocked, {"New games cannot be kept.", "La suite ne sera pas gardée."}},
    {Text::fault_damaged, {"The game kept is damaged.", "La partie gardée est abîmée."}},
    {Text::fault_other_version,
     {"It was made by another version.", "Elle vient d’une autre version."}},
    {Text::fault_diverged,
     {"It does not go as it was recorded.", "Elle ne se rejoue pas telle quelle."}},
    {Text::fault_finished, {"That game is already over.", "Cette partie est déjà finie."}},
    {Text::ok, {"OK", "OK"}},
    {Text::not_kept, {"This game cannot be kept", "Cette partie ne peut être gardée"}},
    {Text::loading, {"Loading your game…", "Chargement de la partie…"}},
    {Text::turns_loaded, {"Turn {0} of {1}", "Tour {0} sur {1}"}},
    {Text::cancel, {"Cancel", "Annuler"}},
    {Text::watch_replay, {"Watch replay", "Revoir"}},
    {Text::replay_title, {"replay", "partie revue"}},
    {Text::replay_state,
     {"{0} · {1} · {2} · {3} · {4} · {5} · {6}", "{0} · {1} · {2} · {3} · {4} · {5} · {6}"}},
    {Text::replay_playing, {"playing ×{0}", "lecture ×{0}"}},
    {Text::replay_paused, {"paused", "en pause"}},
    {Text::play, {"Play", "Lire"}},
    {Text::pause, {"Pause", "Pause"}},
    {Text::one_step, {"Step", "Pas"}},
    {Text::previous_turn, {"‹ Turn", "‹ Tour"}},
    {Text::following_turn, {"Turn ›", "Tour ›"}},
    {Text::slower, {"−", "−"}},
    {Text::faster, {"+", "+"}},
    {Text::times, {"×{0}", "×{0}"}},
    {Text::save_replay, {"Save", "Garder"}},
    {Text::copy, {"Copy", "Copier"}},
    {Text::turn_of_turns, {"Turn {0} of {1}", "Tour {0} sur {1}"}},
    {Text::turn_of_player, {"Turn {0} of {1} · player {2}", "Tour {0} sur {1} · joueur {2}"}},
    {Text::verifying, {"Verifying…", "Vérification…"}},
    {Text::verified, {"Verified", "Vérifiée"}},
    {Text::diverged, {"Diverged in turn {0}", "Diverge au tour {0}"}},
    {Text::hint_replay,
     {"Space: play, pause · point: step · + −: speed · arrows: turns",
      "Espace : lire · point : pas · + − : vitesse · flèches : tours"}},
    {Text::replay_saved, {"Saved as {0}.", "Gardée sous le nom {0}."}},
    {Text::replay_not_saved, {"It cannot be saved.", "Elle ne peut pas être gardée."}},
    {Text::replay_copied,
     {"Copied as text: paste it anywhere.", "Copiée : collez le texte où vous voulez."}},
    {Text::replay_not_copied, {"It cannot be copied.", "Elle ne peut pas être copiée."}},
    {Text::score_pair, {"{0} : {1}", "{0} : {1}"}},
    {Text::saved_replays, {"Saved replays", "Parties gardées"}},
    {Text::paste, {"Paste", "Coller"}},
    {Text::no_replays,
     {"No replay is saved yet. Watch one after a game, or paste its text here.",
      "Rien n’est gardé. Revoyez une partie à sa fin, ou collez-en le texte ici."}},
    {Text::hint_replays,
     {"Choose a replay, or paste one as text (Ctrl+V).",
      "Choisissez, ou collez un texte (Ctrl+V)."}},
    {Text::replay_line, {"{0} · turns: {1} · {2}", "{0} · tours : {1} · {2}"}},
    {Text::replays_state, {"{0} · {1} · replays: {2}", "{0} · {1} · parties : {2}"}},
    {Text::bad_replay, {"Cannot be shown: it is damaged.", "Illisible : le fichier est abîmé."}},
    {Text::old_replay,
     {"Cannot be shown: it was made by another version.",
      "Illisible : elle vient d’une autre version."}},
    {Text::paste_failed, {"Nothing to show", "Rien à montrer"}},
    {Text::paste_damaged,
     {"What was pasted is no whole replay.", "Le texte collé n’est pas une partie."}},
    {Text::paste_other_version,
     {"It was made by another version.", "Elle vient d’une autre version."}},
    {Text::take_back, {"Take back", "Annuler"}},
    {Text::repeat, {"Repeat", "Répéter"}},
    {Text::slower_throw, {"−1 px/s", "−1 px/s"}},
    {Text::faster_throw, {"+1 px/s", "+1 px/s"}},
    {Text::turn_left, {"+0.1°", "+0,1°"}},
    {Text::turn_right, {"−0.1°", "−0,1°"}},
    {Text::hint_repeat,
     {"R repeats {0}. Backspace takes back.", "R répète {0}. Retour arrière : annuler."}},
    {Text::practised, {"{0} px/s, {1}°", "{0} px/s, {1}°"}},
    {Text::practice_state, {"practice: {0}", "exercice : {0}"}},
    {Text::practice_on, {"Practice: on", "Exercice : oui"}},
    {Text::practice_off, {"Practice: off", "Exercice : non"}},
    {Text::hint_practice_levels,
     {"Throws can be taken back; nothing enters the best scores.",
      "Lancers annulables ; aucun record n’est noté."}},
    {Text::practice_only, {"Practice: no best score", "Exercice : pas de record"}},
    {Text::aimed, {"{0}° · {1}", "{0}° · {1}"}},
    {Text::entered_angle, {"{0} °", "{0} °"}},
    {Text::entered_speed, {"{0} px/s", "{0} px/s"}},
    {Text::hint_pull,
     {"Pull the ball back and let go. Keys: arrows, Enter.",
      "Tirez la boule en arrière, lâchez. Clavier : flèches, Entrée."}},
    {Text::hint_let_go,
     {"Let go to shoot. Back to the ball, or Esc: cancel.",
      "Lâchez pour tirer. Retour à la boule ou Échap : annuler."}},
    {Text::hint_turn,
     {"Point to turn; wheel, Space or bar: power. Click to shoot.",
      "Visez ; force : molette, Espace, barre. Cliquez : tirer."}},
    {Text::hint_keys,
     {"Arrows aim, Shift: finer, digits: type it. Enter shoots.",
      "Flèches : viser, Maj : plus fin, chiffres. Entrée : tirer."}},
    {Text::hint_entry,
     {"Type angle and speed. Tab: the other. Enter: take them.",
      "Saisissez angle et vitesse. Tab : l’autre. Entrée : valider."}},
    {Text::points_made, {"Points", "Points"}},
    {Text::balls, {"Balls", "Boules"}},
    {Text::best_turn, {"Best turn", "Meilleur tour"}},
    {Text::shots, {"Shots", "Tirs"}},
    {Text::fouls, {"Fouls", "Fautes"}},
    {Text::settings, {"Settings", "Réglages"}},
    {Text::settings_state, {"{0} · {1} · {2}", "{0} · {1} · {2}"}},
    {Text::settings_broken, {"Settings: starting afresh", "Réglages : valeurs de départ"}},
    {Text::settings_unreadable,
     {"The settings could not be read.", "Les réglages sont illisibles."}},
    {Text::settings_set_aside,
     {"They are kept under another name:", "Ils sont mis de côté sous le nom"}},
    {Text::settings_blocked, {"Changes cannot be saved.", "Rien ne peut être gardé."}},
    {Text::settings_not_kept,
     {"Settings cannot be saved: they last until the end.",
      "Les réglages ne peuvent pas être gardés."}},
    {Text::hint_settings,
     {"Click a line to change it, or use Tab and the arrow keys.",
      "Cliquez sur une ligne, ou touches Tab et flèches."}},
    {Text::tab_general, {"General", "Général"}},
    {Text::tab_picture, {"Picture", "Image"}},
    {Text::tab_aiming, {"Aiming", "Visée"}},
    {Text::tab_players, {"Players", "Joueurs"}},
    {Text::set_language, {"Language", "Langue"}},
    {Text::set_volume, {"Volume", "Volume"}},
    {Text::set_mute, {"Mute", "Muet"}},
    {Text::set_hints, {"Hints", "Conseils"}},
    {Text::set_colours, {"Colours", "Couleurs"}},
    {Text::set_motion, {"Less motion", "Animations réduites"}},
    {Text::set_shake, {"Screen shake", "Secousses"}},
    {Text::set_way, {"Way of aiming", "Façon de viser"}},
    {Text::set_preview, {"Preview", "Aperçu du tir"}},
    {Text::set_name, {"Name of player {0}", "Nom du joueur {0}"}},
    {Text::set_breaks, {"Who breaks", "Qui commence"}},
    {Text::set_keep_turn, {"Scoring plays on", "Marquer rejoue"}},
    {Text::about_language,
     {"The language of everything, at once.", "La langue de tout le jeu, aussitôt."}},
    {Text::about_volume, {"How loud balls and cushions are.", "La force des sons."}},
    {Text::about_mute, {"No sound at all.", "Aucun son."}},
    {Text::about_hints,
     {"Tell what to do when nothing happens for a while.",
      "Dit quoi faire quand rien ne se passe."}},
    {Text::about_colours,
     {"Palettes for eyes that see some colours alike.",
      "Palettes pour qui confond certaines couleurs."}},
    {Text::about_motion,
     {"Fewer moving effects, for those whom they bother.",
      "Moins d’effets animés, s’ils vous gênent."}},
    {Text::about_shake,
     {"A hard shock may shake the picture.", "Un choc violent peut secouer l’image."}},
    {Text::about_way,
     {"What mouse or finger does to aim. The keys always can.",
      "Comment viser à la souris ou au doigt. Les touches y servent toujours."}},
    {Text::about_preview,
     {"How much of the shot is shown ahead. All of it: in practice only.",
      "La part du tir montrée d’avance. Tout : à l’exercice seulement."}},
    {Text::about_name,
     {"Type a name; empty, it is “Player {0}”.", "Tapez un nom ; sans nom : « Joueur {0} »."}},
    {Text::about_breaks,
     {"Who has the first turn, from the next game of billiards on.",
      "Qui joue le premier tour, dès la prochaine partie de billard."}},
    {Text::about_keep_turn,
     {"House rule: who pockets a ball has the next turn too. From the next game on.",
      "Règle maison : qui marque rejoue. Dès la prochaine partie."}},
    {Text::as_system, {"As the system", "Comme le système"}},
    {Text::english, {"English", "English"}},
    {Text::french, {"Français", "Français"}},
    {Text::per_cent, {"{0}%", "{0}\u202f%"}},
    {Text::yes, {"Yes", "Oui"}},
    {Text::no, {"No", "Non"}},
    {Text::colours_standard, {"Standard", "Standard"}},
    {Text::colours_red_green, {"For red and green", "Pour rouge et vert"}},
    {Text::colours_blue_yellow, {"For blue and yellow", "Pour bleu et jaune"}},
    {Text::colours_high_contrast, {"High contrast", "Contraste élevé"}},
    {Text::way_clicks, {"Two clicks", "Deux clics"}},
    {Text::way_pull, {"Drag back, let go", "Tirer et lâcher"}},
    {Text::way_turn, {"Turn, then power", "Tourner, puis doser"}},
    {Text::preview_off, {"Off", "Aucun"}},
    {Text::preview_contact, {"To the first contact", "Premier contact"}},
    {Text::preview_short, {"A little further", "Un peu plus loin"}},
    {Text::preview_full, {"All of it", "Tout"}},
    {Text::breaks_alternate, {"In turn", "À tour de rôle"}},
    {Text::breaks_loser, {"The loser", "Le perdant"}},
    {Text::sound_on, {"Sound on", "Son activé"}},
    {Text::sound_off, {"Sound off (M: on)", "Son coupé (M : rétablir)"}},
    {Text::paused, {"Paused", "Pause"}},
    {Text::hint_paused,
     {"Click, or press any key, to go on.", "Cliquez, ou une touche, pour continuer."}},
    {Text::paused_state, {"paused: {0}", "en pause : {0}"}},
}};

struct LevelName {
  std::string_view english;
  std::string_view french;
};
constexpr std::array level_names{
    LevelName{"First steps", "Premiers pas"},
    LevelName{"Two towers", "Les deux tours"},
    LevelName{"Pass it on", "Faites passer"},
    LevelName{"Off the back wall", "Par la bande"},
    LevelName{"Over the wall", "Par-dessus le mur"},
    LevelName{"Skittles", "Les quilles"},
    LevelName{"The pit", "La fosse"},
    LevelName{"Sentinels", "Les sentinelles"},
    LevelName{"The crown", "La couronne"},
    LevelName{"The fortress", "La forteresse"},
};

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
      entries[static_cast<std::size_t>(text)].in[static_cast<std::size_t>(language())];
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '{') {
      const auto n = static_cast<std::size_t>(pattern[i + 1] - '0');
      if (n < values.size()) out += values.begin()[n];
      i += 2;
    } else {
      out += pattern[i];
    }
  }
  return out;
}

std::string Words::number(int value) const {
  const std::string_view separator = language() == Language::french ? "\u202f" : ",";
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3 && digits[at - 4] != '-';) {
    at -= 3;
    digits.insert(at, separator);
  }
  return digits;
}

std::string Words::tenths(double value) const {
  const auto all = static_cast<int>(std::lround(value * 10));
  const int part = std::abs(all % 10);
  return (all < 0 ? "−" : "") + number(std::abs(all / 10)) +
         (language() == Language::french ? "," : ".") + std::to_string(part);
}

std::string Words::level_name(std::string_view name) const {
  for (const LevelName& known : level_names)
    if (language() == Language::french && known.english == name) return std::string(known.french);
  return std::string(name);
}

std::string Words::player(int player) const {
  const std::string& name = voice_->names[static_cast<std::size_t>(player)];
  return name.empty() ? (*this)(Text::player, {number(player + 1)}) : name;
}

}  // namespace app
