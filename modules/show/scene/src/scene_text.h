#pragma once
// Words of a scene. No other file of this module gives a VTK actor its words, so that each has letters for
// them. Private to scene.

#include <string>

class vtkTextProperty;

namespace facenav::scene {

/// Takes a font that has the words' letters: the one in force, or for other than Latin letters the one that
/// has them.
void useFontFor(const std::string& words, vtkTextProperty& style);

/// Gives a vtkTextActor or vtkBillboardTextActor3D its words.
template <class TextActor>
void setWords(TextActor& actor, const std::string& words) {
  useFontFor(words, *actor.GetTextProperty());
  actor.SetInput(words.c_str());
}

}  // namespace facenav::scene
