"""The interface's texts in German."""

__all__ = ["TEXTS"]

TEXTS = {
    "0° to 90°":
        "0° bis 90°",
    "; ends held":
        "; Enden gehalten",
    "; outside the gamut, mapped by {:s}":
        "; außerhalb des Farbraums, abgebildet mit {:s}",
    "A perfect reflector is neutral in any light, as for an eye that is used to it":
        "Ein vollkommener Reflektor ist in jedem Licht neutral, wie für ein daran gewöhntes Auge",
    "A preset, or a dataset of the database":
        "Eine Voreinstellung oder ein Datensatz der Datenbank",
    "Adapt White":
        "Weiß anpassen",
    "Add Asset Library":
        "Asset-Bibliothek hinzufügen",
    "Add Facet & Film Group":
        "Gruppe von Facet & Film hinzufügen",
    "Add a node group of Facet & Film; one that the file has already is used again":
        "Fügt eine Node-Gruppe von Facet & Film hinzu; eine schon vorhandene wird wieder verwendet",
    "Add the materials and node groups to the Asset Browser, as a library in Preferences, File Paths":
        "Fügt Materialien und Node-Gruppen dem Asset-Browser hinzu, als Bibliothek unter Einstellungen, Dateipfade",
    "Alloys":
        "Legierungen",
    "Another Version":
        "Andere Version",
    "Apply":
        "Anwenden",
    "Apply Saved Preset":
        "Gespeicherte Voreinstellung anwenden",
    "Apply a material of Facet & Film first: there is nothing to save":
        "Erst ein Material von Facet & Film anwenden: Es gibt nichts zu speichern",
    "Apply to Node":
        "Auf Node anwenden",
    "As Cook and Torrance published them in 1982":
        "Wie von Cook und Torrance 1982 veröffentlicht",
    "Asset Library":
        "Asset-Bibliothek",
    "At 0°":
        "Bei 0°",
    "Bake Spectral Preset":
        "Spektrale Voreinstellung backen",
    "Bake a material into the active material slot of the active object, and put it on the other selected ones":
        "Backt ein Material in den aktiven Materialslot des aktiven Objekts und gibt es den anderen ausgewählten",
    "Bake a measured material first: there is nothing to bake again":
        "Erst ein gemessenes Material backen: Es gibt nichts neu zu backen",
    "Bake a preset first: this material is not one of Facet & Film":
        "Erst eine Voreinstellung backen: Dieses Material ist keines von Facet & Film",
    "Bake a preset into the selected group node; what is plugged into it stays":
        "Backt eine Voreinstellung in den ausgewählten Gruppen-Node; was eingesteckt ist, bleibt",
    "Bake every measured material of this file again, in the light and working space chosen above. Esc stops it, and then nothing is changed":
        "Backt jedes gemessene Material dieser Datei neu, im oben gewählten Licht und Arbeitsfarbraum. Esc bricht ab, dann ändert sich nichts",
    "Bake optical constants from a file: CSV or text of wavelength, n, k or of wavelength, R; refractiveindex.info's CSV and YAML; SOPRA and LuxPop .nk":
        "Backt optische Konstanten aus einer Datei: CSV oder Text mit Wellenlänge, n, k oder Wellenlänge, R; CSV und YAML von refractiveindex.info; .nk von SOPRA und LuxPop",
    "Bake optical constants from the clipboard: a table of wavelength, n, k or of wavelength, R":
        "Backt optische Konstanten aus der Zwischenablage: eine Tabelle mit Wellenlänge, n, k oder Wellenlänge, R",
    "Bake this material's measurement again in the light and working space chosen here; what else you set stays":
        "Backt die Messung dieses Materials neu, im hier gewählten Licht und Arbeitsfarbraum; was sonst eingestellt ist, bleibt",
    "Baking {:s}, {:d} more   (Esc stops)":
        "Backt {:s}, noch {:d}   (Esc bricht ab)",
    "Bring this file's materials by an older Facet & Film up to date; every value and link stays":
        "Bringt Materialien dieser Datei von einem älteren Facet & Film auf den neuen Stand; alle Werte und Verbindungen bleiben",
    "CIE standard observer":
        "CIE-Normalbeobachter",
    "CIEDE2000 at most {:.2f}":
        "CIEDE2000 höchstens {:.2f}",
    "CSV of the Curve":
        "CSV der Kurve",
    "CSV of the Spectrum":
        "CSV des Spektrums",
    "Check":
        "Prüfen",
    "Check Against a Measurement":
        "Mit einer Messung prüfen",
    "Citation":
        "Quelle",
    "Clip":
        "Abschneiden",
    "Colour of a preset's mirror over the angle, for any shader":
        "Spiegelfarbe einer Voreinstellung über dem Winkel, für jeden Shader",
    "Colour over angle: cos_theta, r, g, b":
        "Farbe über dem Winkel: cos_theta, r, g, b",
    "Compare Measurements":
        "Messungen vergleichen",
    "Cook–Torrance Exact":
        "Cook–Torrance exakt",
    "Cook–Torrance Fast":
        "Cook–Torrance schnell",
    "Cook–Torrance OSL":
        "Cook–Torrance OSL",
    "Crystals":
        "Kristalle",
    "Cut every channel off at 0 and 1":
        "Schneidet jeden Kanal bei 0 und 1 ab",
    "Darken all colours of the material alike, until the largest channel fits":
        "Dunkelt alle Farben des Materials gleich ab, bis der größte Kanal passt",
    "Data":
        "Daten",
    "Dataset":
        "Datensatz",
    "Desaturate":
        "Entsättigen",
    "Device":
        "Gerät",
    "Does this Blender render the published formulas? Find out on this machine:":
        "Rendert dieses Blender die veröffentlichten Formeln? Hier lässt es sich prüfen:",
    "Edge Tint":
        "Randtönung",
    "Everything that was baked":
        "Alles, was gebacken wurde",
    "Exact":
        "Exakt",
    "Export Measurement":
        "Messung exportieren",
    "Extinction for red, green and blue":
        "Extinktion für Rot, Grün und Blau",
    "F0 and Edge Tint":
        "F0 und Randtönung",
    "F82 Tint":
        "F82-Tönung",
    "F82 tint":
        "F82-Tönung",
    "Facets with native closures; also in EEVEE":
        "Facetten mit eingebauten Shadern; auch in EEVEE",
    "Facets with rms slope m, conductor Fresnel, diffuse part (1982)":
        "Facetten mit mittlerer Steigung m, Fresnel für Leiter, diffuser Anteil (1982)",
    "Fast":
        "Schnell",
    "File":
        "Datei",
    "File of optical constants":
        "Datei mit optischen Konstanten",
    "File to write":
        "Zu schreibende Datei",
    "File's Working Space":
        "Arbeitsfarbraum der Datei",
    "Fit":
        "Anpassung",
    "Form":
        "Form",
    "Fresnel Ramp":
        "Fresnel-Verlauf",
    "Gamut":
        "Farbumfang",
    "Give a preset that you saved another name":
        "Gibt einer gespeicherten Voreinstellung einen anderen Namen",
    "Glasses":
        "Gläser",
    "Group":
        "Gruppe",
    "How the formula becomes a Cycles material":
        "Wie die Formel zu einem Cycles-Material wird",
    "Illuminant":
        "Lichtart",
    "Import Measurement":
        "Messung importieren",
    "In the Asset Browser as Facet & Film":
        "Im Asset-Browser als Facet & Film",
    "Inside, unchanged":
        "Innerhalb, unverändert",
    "Interference and colour separation in a thin layer (Granier and Heidrich)":
        "Interferenz und Farbtrennung in einer dünnen Schicht (Granier und Heidrich)",
    "Keep colours outside of the gamut":
        "Behält Farben außerhalb des Farbumfangs",
    "Kind":
        "Art",
    "Large fields of view":
        "Große Sehfelder",
    "Layer Thickness":
        "Schichtdicke",
    "Layered RGB Exact":
        "Layered RGB exakt",
    "Layered RGB Fast":
        "Layered RGB schnell",
    "Layered RGB OSL":
        "Layered RGB OSL",
    "Leave":
        "Belassen",
    "Left out, as they take no materials or are linked: {:s}":
        "Ausgelassen, da sie keine Materialien nehmen oder verknüpft sind: {:s}",
    "Light":
        "Licht",
    "Light and Gamut":
        "Licht und Farbumfang",
    "Light in which the material has its colour; D65 is daylight, and white in Blender":
        "Licht, in dem das Material seine Farbe hat; D65 ist Tageslicht und in Blender weiß",
    "Linear Rec.709, Blender's default":
        "Lineares Rec.709, Blenders Voreinstellung",
    "Liquids":
        "Flüssigkeiten",
    "Make the active material slot the material that you saved":
        "Macht den aktiven Materialslot zum gespeicherten Material",
    "Material":
        "Material",
    "Material: a preset's name, or a dataset such as main/Cu/Johnson. Type to search":
        "Material: Name einer Voreinstellung, oder ein Datensatz wie main/Cu/Johnson. Tippen sucht",
    "Measured Material":
        "Gemessenes Material",
    "Measurement":
        "Messung",
    "Metals":
        "Metalle",
    "Model":
        "Modell",
    "Name a saved preset, and a new name with at least one letter":
        "Eine gespeicherte Voreinstellung nennen und einen neuen Namen mit mindestens einem Buchstaben",
    "Native closures from an OSL script: needs Open Shading Language switched on":
        "Eingebaute Shader aus einem OSL-Skript: Open Shading Language muss eingeschaltet sein",
    "Native closures: light-sampled, on every device, and in EEVEE":
        "Eingebaute Shader: mit Lichtabtastung, auf jedem Gerät und in EEVEE",
    "New Name":
        "Neuer Name",
    "OSL Fast":
        "OSL schnell",
    "OSL needs the CPU or OptiX: change the device, or take Exact":
        "OSL braucht die CPU oder OptiX: Gerät wechseln oder Exakt nehmen",
    "Observer":
        "Beobachter",
    "Open a material in the Shader Editor first":
        "Erst ein Material im Shader-Editor öffnen",
    "Other Conductors":
        "Andere Leiter",
    "Outside: {:s}, channels moved by up to {:.3f}":
        "Außerhalb: {:s}, Kanäle um bis zu {:.3f} verschoben",
    "Oxides":
        "Oxide",
    "Parameters":
        "Parameter",
    "Paste Measurement":
        "Messung einfügen",
    "Polymers":
        "Polymere",
    "Preset":
        "Voreinstellung",
    "Preset by its picture; the filter beside the name chooses the kind":
        "Voreinstellung nach ihrem Bild; der Filter neben dem Namen wählt die Art",
    "Preset or dataset":
        "Voreinstellung oder Datensatz",
    "Preset or dataset to compare":
        "Zu vergleichende Voreinstellung oder Datensatz",
    "Preset or dataset to compare with":
        "Voreinstellung oder Datensatz zum Vergleich",
    "Presets":
        "Voreinstellungen",
    "Re-bake":
        "Neu backen",
    "Re-bake All Materials":
        "Alle Materialien neu backen",
    "Realisation":
        "Umsetzung",
    "Reflectance at normal incidence":
        "Reflexionsgrad bei senkrechtem Einfall",
    "Reflectance at normal incidence and F82 tint for red, green and blue":
        "Reflexionsgrad bei senkrechtem Einfall und F82-Tönung für Rot, Grün und Blau",
    "Reflectance model":
        "Reflexionsmodell",
    "Refractive index and extinction for red, green and blue":
        "Brechungsindex und Extinktion für Rot, Grün und Blau",
    "Refractive index for red, green and blue":
        "Brechungsindex für Rot, Grün und Blau",
    "Remove Asset Library":
        "Asset-Bibliothek entfernen",
    "Rename Preset":
        "Voreinstellung umbenennen",
    "Render every model and realisation in a second Blender, compare the pixels with the published formulas, and open the report. Takes one to five minutes; Esc stops it":
        "Rendert jedes Modell und jede Umsetzung in einem zweiten Blender, vergleicht die Pixel mit den veröffentlichten Formeln und öffnet den Bericht. Dauert eine bis fünf Minuten; Esc bricht ab",
    "Render this material by another realisation; every value and link that you set stays":
        "Rendert dieses Material mit einer anderen Umsetzung; alle Werte und Verbindungen bleiben",
    "Renders by {:s}":
        "Rendert mit: {:s}",
    "Save Preset":
        "Voreinstellung speichern",
    "Save the active material under a name of your own, or delete a saved one":
        "Speichert das aktive Material unter eigenem Namen oder löscht ein gespeichertes",
    "Scale":
        "Skalieren",
    "Scene-linear space that the colours are written in":
        "Szenenlinearer Farbraum, in dem die Farben geschrieben werden",
    "Select a group node of Facet & Film first":
        "Erst einen Gruppen-Node von Facet & Film auswählen",
    "Select a group of Facet & Film, or add one: Add, Facet & Film":
        "Eine Gruppe von Facet & Film auswählen oder hinzufügen: Hinzufügen, Facet & Film",
    "Select an object first: the preset is baked into its active material slot":
        "Erst ein Objekt auswählen: Die Voreinstellung wird in dessen aktiven Materialslot gebacken",
    "Semiconductors":
        "Halbleiter",
    "Show F0, F82 and how many CIEDE2000 typed-in values or a material lie from a measured material":
        "Zeigt F0, F82 und um wie viel CIEDE2000 eingegebene Werte oder ein Material von einem gemessenen abweichen",
    "Show all measurements of the same material side by side: published values differ from lab to lab":
        "Zeigt alle Messungen desselben Materials nebeneinander: Veröffentlichte Werte unterscheiden sich von Labor zu Labor",
    "Small fields of view; what displays are calibrated for":
        "Kleine Sehfelder; darauf sind Bildschirme kalibriert",
    "Stopped: no material was changed":
        "Abgebrochen: Kein Material wurde geändert",
    "Sulphides":
        "Sulfide",
    "Switch Realisation":
        "Umsetzung wechseln",
    "Take the library off the Asset Browser again; what was dragged from it stays":
        "Nimmt die Bibliothek wieder aus dem Asset-Browser; was daraus gezogen wurde, bleibt",
    "The Paper's Figures":
        "Abbildungen der Veröffentlichung",
    "The devices that are switched on under System, Cycles Render Devices":
        "Die unter System, Cycles-Rendergeräte eingeschalteten Geräte",
    "The measured points: wavelength_nm, n, k":
        "Die gemessenen Punkte: wavelength_nm, n, k",
    "The preset to rename":
        "Die umzubenennende Voreinstellung",
    "The processor":
        "Der Prozessor",
    "The published formula as an OSL script":
        "Die veröffentlichte Formel als OSL-Skript",
    "The published formula itself as an OSL script: needs Open Shading Language switched on in Render properties, on the CPU or OptiX; EEVEE shows Fast":
        "Die veröffentlichte Formel selbst als OSL-Skript: Open Shading Language muss in den Render-Eigenschaften eingeschaltet sein, auf CPU oder OptiX; EEVEE zeigt Schnell",
    "The published formula itself, sampled with nodes alone, on every device; EEVEE shows Fast":
        "Die veröffentlichte Formel selbst, allein mit Nodes abgetastet, auf jedem Gerät; EEVEE zeigt Schnell",
    "The published formula, nodes alone":
        "Die veröffentlichte Formel, allein mit Nodes",
    "The scene-linear space of this file":
        "Der szenenlineare Farbraum dieser Datei",
    "There is a preset called {:s} already":
        "Es gibt schon eine Voreinstellung namens {:s}",
    "Thickness in nanometres that varies over the surface, with its lower normal":
        "Dicke in Nanometern, die über die Fläche wechselt, mit ihrer unteren Normalen",
    "Thin layer with native closures; also in EEVEE":
        "Dünne Schicht mit eingebauten Shadern; auch in EEVEE",
    "This engine renders Fast in its place: for this realisation choose Cycles in the Render properties":
        "Diese Engine rendert stattdessen Schnell: Für diese Umsetzung in den Render-Eigenschaften Cycles wählen",
    "This file has no material with a measurement: bake a preset first":
        "Diese Datei hat kein Material mit einer Messung: Erst eine Voreinstellung backen",
    "This realisation is an OSL script and would render black: switch on Open Shading Language in the Render properties, or take Exact":
        "Diese Umsetzung ist ein OSL-Skript und würde schwarz rendern: Open Shading Language in den Render-Eigenschaften einschalten oder Exakt nehmen",
    "Towards grey of the same luminance, until inside: the hue stays":
        "Zum Grau gleicher Leuchtdichte hin, bis innerhalb: Der Farbton bleibt",
    "Update Materials":
        "Materialien aktualisieren",
    "Verify Against the Formulas":
        "Mit den Formeln prüfen",
    "Verify on CPU":
        "Auf der CPU prüfen",
    "Verify on GPU":
        "Auf der GPU prüfen",
    "Wavelengths":
        "Wellenlängen",
    "What to call it":
        "Wie sie heißen soll",
    "What to compare":
        "Was verglichen wird",
    "What to do with colours that the working space cannot hold":
        "Was mit Farben geschieht, die der Arbeitsfarbraum nicht fasst",
    "What to render the probes on":
        "Worauf die Proben gerendert werden",
    "What to write":
        "Was geschrieben wird",
    "Which group to add":
        "Welche Gruppe hinzugefügt wird",
    "Which presets to show pictures of":
        "Von welchen Voreinstellungen Bilder gezeigt werden",
    "Workbench shows the viewport colour only: choose Cycles in the Render properties":
        "Workbench zeigt nur die Ansichtsfarbe: In den Render-Eigenschaften Cycles wählen",
    "Working Space":
        "Arbeitsfarbraum",
    "Write what was baked into the active material as JSON, CSV or MaterialX":
        "Schreibt, was in das aktive Material gebacken wurde, als JSON, CSV oder MaterialX",
    "Wrote {:s}":
        "{:s} geschrieben",
    "You have saved no preset yet":
        "Es ist noch keine Voreinstellung gespeichert",
    "n and k":
        "n und k",
    "{:d} materials baked again":
        "{:d} Materialien neu gebacken",
    "{:s} applied":
        "{:s} angewandt",
    "{:s} baked from {:s}: largest CIEDE2000 of the fit {:.2f}":
        "{:s} aus {:s} gebacken: größter CIEDE2000 der Anpassung {:.2f}",
    "{:s} is a library override, whose nodes and slots belong to another file: make it local first (Object, Relations, Make Local)":
        "{:s} ist eine Bibliotheksüberschreibung, deren Nodes und Slots einer anderen Datei gehören: erst lokal machen (Objekt, Relationen, Lokal machen)",
    "{:s} is linked from another file: make it local first (Object, Relations, Make Local)":
        "{:s} ist aus einer anderen Datei verknüpft: erst lokal machen (Objekt, Relationen, Lokal machen)",
    "{:s} renders by {:s}":
        "{:s} rendert mit: {:s}",
    "{:s} takes no materials: select a mesh, curve, surface, text or volume":
        "{:s} nimmt keine Materialien: ein Mesh, eine Kurve, Fläche, Text oder ein Volumen auswählen",
}
