"""The interface's texts in German."""

__all__ = ["TEXTS"]

TEXTS = {
    "   (Esc stops)":
        "   (Esc bricht ab)",
    " or ":
        " oder ",
    ". Saved among your presets as {:s}":
        ". Unter den eigenen Voreinstellungen gespeichert als {:s}",
    "0° to 90°":
        "0° bis 90°",
    "; ends held":
        "; Enden gehalten",
    "; outside the gamut, mapped by {:s}":
        "; außerhalb des Farbraums, abgebildet mit {:s}",
    "; the marks of the finish stay in Blender, its roughness is in it":
        "; die Spuren der Oberfläche bleiben in Blender, ihre Rauheit ist darin",
    "A Fresnel curve is angles from 0° to 90° with three reflectances from 0 to 1 each, such as 'Fresnel 0° 0.1 0.1 0.1 / 90° 1 1 1', not {value!r}.":
        "Eine Fresnel-Kurve besteht aus Winkeln von 0° bis 90° mit je drei Reflexionsgraden von 0 bis 1, etwa 'Fresnel 0° 0.1 0.1 0.1 / 90° 1 1 1', nicht {value!r}.",
    "A button in the headers of the 3D Viewport and of the Shader Editor":
        "Ein Knopf in den Kopfleisten der 3D-Ansicht und des Shader-Editors",
    "A check takes one of: n with k, F0 with or without a tint, a material.":
        "Geprüft wird eines von: n mit k, F0 mit oder ohne Tönung, ein Material.",
    "A conductor's, by its complex refractive index":
        "Die eines Leiters, nach seinem komplexen Brechungsindex",
    "A dielectric's, by its reflectance at normal incidence":
        "Die eines Nichtleiters, nach seinem Reflexionsgrad bei senkrechtem Einfall",
    "A file to write is named by its path, not by {path!r}.":
        "Eine Datei zum Schreiben heißt nach ihrem Pfad, nicht {path!r}.",
    "A finish is called by its name, such as 'brushed', not {value!r}.":
        "Eine Oberfläche wird mit ihrem Namen genannt, etwa 'brushed', nicht {value!r}.",
    "A finish varies the roughness, which {model} has not: name a material of another model, or no finish.":
        "Eine Oberfläche verändert die Rauheit, die {model} nicht hat: Nennen Sie ein Material eines anderen Modells "
        "oder keine Oberfläche.",
    "A material is a preset's name or a dataset's id, not {value!r}.":
        "Ein Material ist der Name einer Voreinstellung oder die Kennung eines Datensatzes, nicht {value!r}.",
    "A metal's color towards the edge is lost there.":
        "Die Farbe eines Metalls zum Rand hin geht dort verloren.",
    "A perfect reflector is neutral in any light, as for an eye that is used to it":
        "Ein vollkommener Reflektor ist in jedem Licht neutral, wie für ein daran gewöhntes Auge",
    "A preset and {name} both say what the material is made of: give one of them.":
        "Eine Voreinstellung und {name} sagen beide, woraus das Material ist: nur eines davon angeben.",
    "A preset is called by its name, such as 'copper', not {value!r}.":
        "Eine Voreinstellung heißt nach ihrem Namen, etwa 'copper', nicht {value!r}.",
    "A preset, or a dataset of the database":
        "Eine Voreinstellung oder ein Datensatz der Datenbank",
    "A second Blender could not be started: {why}":
        "Ein zweites Blender ließ sich nicht starten: {why}",
    "A stack has at most {most} films; this one has {count}.":
        "Ein Schichtstapel hat höchstens {most} Schichten; dieser hat {count}.",
    "A stack is a text such as 'SiO2 0-1000 nm / Si', from the outside in, not {value!r}.":
        "Ein Schichtstapel ist ein Text wie 'SiO2 0-1000 nm / Si', von außen nach innen, nicht {value!r}.",
    "A stack of {films} films has {indices} indices: outside, films and substrate; {given} were given.":
        "Ein Stapel aus {films} Schichten hat {indices} Brechzahlen: außen, Schichten und Träger; gegeben "
        "sind {given}.",
    "A tab in the sidebar of the 3D Viewport":
        "Ein Reiter in der Seitenleiste der 3D-Ansicht",
    "A table has at most {most} entries, not {rows} × {columns}; take fewer rows or columns.":
        "Eine Tabelle hat höchstens {most} Einträge, nicht {rows} × {columns}; weniger Zeilen oder Spalten nehmen.",
    "A thickness that varies becomes its middle.":
        "Aus einer Dicke, die wechselt, wird ihre Mitte.",
    "A thin layer after Granier and Heidrich, clean and fast, in Cycles and in EEVEE: the one to take first":
        "Eine dünne Schicht nach Granier und Heidrich, rauscharm und schnell, in Cycles und in EEVEE: die erste Wahl",
    "A verification is running":
        "Eine Prüfung läuft",
    "Absorption":
        "Absorption",
    "Absorption over the depth is lost there: the color is that of the mean depth.":
        "Absorption über die Tiefe geht dort verloren: die Farbe ist die der mittleren Tiefe.",
    "Active Slot":
        "Aktiver Slot",
    "Adapt White":
        "Weiß anpassen",
    "Add":
        "Hinzufügen",
    "Add Asset Library":
        "Asset-Bibliothek hinzufügen",
    "Add Facet & Film Group":
        "Gruppe von Facet & Film hinzufügen",
    "Add a layer below the chosen one":
        "Eine Schicht unter der gewählten hinzufügen",
    "Add a node group of Facet & Film; one that the file has already is used again":
        "Fügt eine Node-Gruppe von Facet & Film hinzu; eine schon vorhandene wird wieder verwendet",
    "Add the materials and node groups to the Asset Browser, as a library of your preferences":
        "Fügt die Materialien und Nodegruppen dem Asset-Browser hinzu, als Bibliothek in den Einstellungen",
    "Against":
        "Gegen",
    "Against: {:s}":
        "Gegen: {:s}",
    "Air":
        "Luft",
    "All Slots":
        "Alle Slots",
    "All materials of Facet & Film in this file are in its working space":
        "Alle Materialien von Facet & Film in dieser Datei sind in deren Arbeitsfarbraum",
    "Amount":
        "Menge",
    "An even sheen without marks":
        "Ein gleichmäßiger Glanz ohne Spuren",
    "An even, fine grain, for Roughness, Normal and Diffuse Color":
        "Ein gleichmäßiges, feines Korn, für Rauheit, Normale und diffuse Farbe",
    "Anisotropy":
        "Anisotropie",
    "Anisotropy is lost there.":
        "Anisotropie geht dort verloren.",
    "Another Version":
        "Andere Version",
    "Apply":
        "Anwenden",
    "Apply Finish":
        "Oberfläche anwenden",
    "Apply Material":
        "Material anwenden",
    "Apply Saved Preset":
        "Gespeicherte Voreinstellung anwenden",
    "Apply a material of Facet & Film first: there is nothing to save":
        "Erst ein Material von Facet & Film anwenden: Es gibt nichts zu speichern",
    "Apply to Node":
        "Auf Node anwenden",
    "As published beside it":
        "Wie daneben veröffentlicht",
    "As smooth or rough as the preset says":
        "So glatt oder rau, wie die Voreinstellung sagt",
    "At 0°":
        "Bei 0°",
    "At {place!r}: a bracket has no other; films that repeat are written '(TiO2 58 nm / SiO2 94 nm)x8'.":
        "Bei {place!r}: Einer Klammer fehlt die andere; Wiederholtes schreibt man '(TiO2 58 nm / SiO2 94 nm)x8'.",
    "At {place!r}: a film is named with its thickness, such as 'SiO2 100 nm', or with a range, 'SiO2 0-1000 nm'.":
        "Bei {place!r}: Eine Schicht steht mit ihrer Dicke, etwa 'SiO2 100 nm', oder mit einem Bereich, "
        "'SiO2 0-1000 nm'.",
    "At {place!r}: a layer is missing between two slashes or at an end.":
        "Bei {place!r}: Zwischen zwei Schrägstrichen oder an einem Ende fehlt eine Schicht.",
    "At {place!r}: a thickness is from 0 nm on, the lower end of a range first.":
        "Bei {place!r}: Eine Dicke ist mindestens 0 nm, das untere Ende eines Bereichs steht zuerst.",
    "At {place!r}: films repeat 1 to {most} times, not {times}.":
        "Bei {place!r}: Schichten wiederholen sich 1- bis {most}-mal, nicht {times}-mal.",
    "At {place!r}: the last layer is what is below all films and has no thickness; name it after another ' / '.":
        "Bei {place!r}: Als Letztes steht, was unter allen Schichten liegt, ohne Dicke; es folgt nach einem "
        "weiteren ' / '.",
    "At {place!r}: what is outside stands before one bar, and there are more.":
        "Bei {place!r}: Was außen ist, steht vor einem senkrechten Strich, und hier sind mehrere.",
    "At {place!r}: {why}":
        "Bei {place!r}: {why}",
    "Axis":
        "Achse",
    "Azimuth":
        "Azimut",
    "Bake":
        "Backen",
    "Bake Spectral Preset":
        "Spektrale Voreinstellung backen",
    "Bake a material of the catalogue or a dataset, in the light chosen here, and put it on the selected objects":
        "Backt ein Material des Katalogs oder einen Datensatz in dem hier gewählten Licht und gibt es den gewählten "
        "Objekten",
    "Bake a measured material first: there is nothing to bake again":
        "Erst ein gemessenes Material backen: Es gibt nichts neu zu backen",
    "Bake a measured material first: there is nothing to export":
        "Erst ein gemessenes Material backen: Es gibt nichts zu exportieren",
    "Bake a measurement from a file: tables of n and k, permittivity or reflectance in any layout and unit; refractiveindex.info, SOPRA, WVASE, Zemax, CGATS, JSON and others":
        "Backt eine Messung aus einer Datei: Tabellen von n und k, Permittivität oder Reflexionsgrad in jeder Anordnung und Einheit; refractiveindex.info, SOPRA, WVASE, Zemax, CGATS, JSON und andere",
    "Bake a measurement from the clipboard: a table of n and k, permittivity or reflectance":
        "Backt eine Messung aus der Zwischenablage: eine Tabelle von n und k, Permittivität oder Reflexionsgrad",
    "Bake a preset first: this material is not one of Facet & Film":
        "Erst eine Voreinstellung backen: Dieses Material ist keines von Facet & Film",
    "Bake a preset into the selected group node; what is plugged into it stays":
        "Backt eine Voreinstellung in den ausgewählten Gruppen-Node; was eingesteckt ist, bleibt",
    "Bake every measured material of this file again, in the light and working space chosen above. Esc stops it, and then nothing is changed":
        "Backt jedes gemessene Material dieser Datei neu, im oben gewählten Licht und Arbeitsfarbraum. Esc bricht ab, dann ändert sich nichts",
    "Bake these layers into the material: its roughness, its textures and what else you set stay":
        "Diese Schichten in das Material backen: Rauheit, Texturen und was sonst eingestellt ist, bleiben",
    "Bake this material's measurement again in the light and working space chosen here; what else you set stays":
        "Backt die Messung dieses Materials neu, im hier gewählten Licht und Arbeitsfarbraum; was sonst eingestellt ist, bleibt",
    "Baking {:s}, {:d} more   (Esc stops)":
        "Backt {:s}, noch {:d}   (Esc bricht ab)",
    "Beckmann":
        "Beckmann",
    "Best":
        "Beste",
    "Bring all Facet & Film materials that were baked for another working space into this file's: baked "
    "again, and what you changed moved along. Esc stops it, and then nothing is changed":
        "Alle Materialien von Facet & Film, die für einen anderen Arbeitsfarbraum gebacken wurden, in den "
        "dieser Datei bringen: neu gebacken, und was du geändert hast, kommt mit. Esc bricht ab, dann ist "
        "nichts geändert",
    "Bring this file's materials by an older Facet & Film up to date; every value and link stays":
        "Bringt Materialien dieser Datei von einem älteren Facet & Film auf den neuen Stand; alle Werte und Verbindungen bleiben",
    "Brushed":
        "Gebürstet",
    "Brushed Circular":
        "Kreisförmig gebürstet",
    "Brushed, Circular":
        "Gebürstet, kreisförmig",
    "CIE standard observer":
        "CIE-Normalbeobachter",
    "CIEDE2000 at most {:.2f}":
        "CIEDE2000 höchstens {:.2f}",
    "CIEDE2000 {:.2f} on average, below {:.1f} in 95 %":
        "CIEDE2000 im Mittel {:.2f}, in 95 % unter {:.1f}",
    "CSV of the Curve":
        "CSV der Kurve",
    "CSV of the Spectrum":
        "CSV des Spektrums",
    "Cast":
        "Gegossen",
    "Cauchy b":
        "Cauchy b",
    "Cauchy c":
        "Cauchy c",
    "Change":
        "Änderung",
    "Change Layers":
        "Schichten ändern",
    "Change the list of layers":
        "Die Liste der Schichten ändern",
    "Check":
        "Prüfen",
    "Check Against a Measurement":
        "Mit einer Messung prüfen",
    "Choose a Material":
        "Material auswählen",
    "Choose a clear material first, such as water: it is what the face's normals point out of":
        "Zuerst ein klares Material wählen, etwa Wasser: aus ihm weisen die Normalen der Fläche heraus",
    "Choose a file: here stands what it is read as":
        "Eine Datei wählen: Hier steht, als was sie gelesen wird",
    "Choose a material by its picture, above":
        "Oben ein Material nach seinem Bild auswählen",
    "Choose a material that is made of layers first, such as anodised titanium":
        "Zuerst ein Material aus Schichten wählen, etwa eloxiertes Titan",
    "Citation":
        "Quelle",
    "Clean and fast, on every device and in EEVEE: the one to take first":
        "Rauscharm und schnell, auf jedem Gerät und in EEVEE: die erste Wahl",
    "Clear Dispersive":
        "Klar, mit Dispersion",
    "Clear Standard":
        "Klar, Standard",
    "Clip":
        "Abschneiden",
    "Colour of a preset's mirror over the angle, for any shader":
        "Spiegelfarbe einer Voreinstellung über dem Winkel, für jeden Shader",
    "Colour over angle: cos_theta, r, g, b":
        "Farbe über dem Winkel: cos_theta, r, g, b",
    "Columns":
        "Spalten",
    "Common Face of Two Bodies":
        "Gemeinsame Fläche zweier Körper",
    "Compare Measurements":
        "Messungen vergleichen",
    "Concentration":
        "Konzentration",
    "Cook and Torrance's own choice, with a wider foot":
        "Die Wahl von Cook und Torrance, mit breiterem Fuß",
    "Cook-Torrance OSL":
        "Cook–Torrance OSL",
    "Cook-Torrance Reference":
        "Cook–Torrance, Referenz",
    "Cook-Torrance Standard":
        "Cook–Torrance, Standard",
    "Curve":
        "Kurve",
    "Cut every channel off at 0 and 1":
        "Schneidet jeden Kanal bei 0 und 1 ab",
    "Darken all colours of the material alike, until the largest channel fits":
        "Dunkelt alle Farben des Materials gleich ab, bis der größte Kanal passt",
    "Data":
        "Daten",
    "Dataset":
        "Datensatz",
    "Dataset {dataset!r} covers less than 50 nm of the visible, 400 to 700 nm; choose another.":
        "Datensatz {dataset!r} deckt weniger als 50 nm des Sichtbaren, 400 bis 700 nm; bitte einen anderen wählen.",
    "Dataset {dataset!r} has k but no n: no reflectance follows; choose another.":
        "Datensatz {dataset!r} hat k, aber kein n: Daraus folgt kein Reflexionsgrad; bitte einen anderen wählen.",
    "Depth":
        "Tiefe",
    "Depth Color":
        "Farbe in der Tiefe",
    "Desaturate":
        "Entsättigen",
    "Deviation":
        "Abweichung",
    "Device":
        "Gerät",
    "Diffuse":
        "Diffus",
    "Diffuse Color":
        "Diffuse Farbe",
    "Dispersion":
        "Dispersion",
    "Dispersion Curve":
        "Dispersionskurve",
    "Dispersion is lost there.":
        "Dispersion geht dort verloren.",
    "Dispersive":
        "Mit Dispersion",
    "Distribution":
        "Verteilung",
    "Does this Blender render the published formulas? Find out on this machine:":
        "Rendert dieses Blender die veröffentlichten Formeln? Hier lässt es sich prüfen:",
    "Drained":
        "Abgelaufen",
    "Drop Material":
        "Material ablegen",
    "Drop on {:s}   (Esc stops)":
        "Auf {:s} ablegen   (Esc bricht ab)",
    "Drop this material on an object: it goes into the slot of the face under the mouse":
        "Legt dieses Material auf einem Objekt ab: Es kommt in den Slot der Fläche unter der Maus",
    "Dull and tarnished, rubbed bright at the edges":
        "Matt und angelaufen, an den Kanten blank gerieben",
    "Edge Roughness":
        "Rauheit der Kanten",
    "Edge Tint":
        "Randtönung",
    "Edge Width":
        "Breite der Kanten",
    "Edges rubbed bright, for Roughness and Tint":
        "Blank geriebene Kanten, für Rauheit und Tönung",
    "Entries in the Object menu and in the context menus of objects, faces and material slots":
        "Einträge im Objekt-Menü und in den Kontextmenüs von Objekten, Flächen und Materialslots",
    "Every parameter":
        "Alle Parameter",
    "Every wavelength refracted by its own index, for rainbows in gems and prisms; noisier, and EEVEE shows it without them":
        "Jede Wellenlänge mit eigener Brechzahl, für Regenbögen in Edelsteinen und Prismen; rauscht mehr, und EEVEE zeigt es ohne sie",
    "Everything in this file is of this version":
        "Alles in dieser Datei ist von dieser Version",
    "Everything that was baked":
        "Alles, was gebacken wurde",
    "Exponent R":
        "Exponent R",
    "Exponent T":
        "Exponent T",
    "Export Measurement":
        "Messung exportieren",
    "Extinction for red, green and blue":
        "Extinktion für Rot, Grün und Blau",
    "Extinction k":
        "Extinktion k",
    "F0 and Edge Tint":
        "F0 und Randtönung",
    "F82 Tint":
        "F82-Tönung",
    "F82 tint":
        "F82-Tönung",
    "Face Is Against":
        "Fläche liegt an",
    "Facet & Film Material...":
        "Facet & Film: Material ...",
    "File":
        "Datei",
    "File of a measured BRDF":
        "Datei einer gemessenen BRDF",
    "File of optical constants":
        "Datei mit optischen Konstanten",
    "File to write":
        "Zu schreibende Datei",
    "File's Working Space":
        "Arbeitsfarbraum der Datei",
    "Film Anodising":
        "Film Anodisieren",
    "Film Heat Tint":
        "Film Anlauffarbe",
    "Film OSL":
        "Film, OSL",
    "Film Reference":
        "Film, Referenz",
    "Film Standard":
        "Film, Standard",
    "Film Thickness":
        "Filmdicke",
    "Films from the outside in":
        "Schichten von außen nach innen",
    "Films of measured layers by an OSL script, to read: the formula at the angle of every facet":
        "Stapel gemessener dünner Schichten als OSL-Skript, zum Lesen: die Formel im Winkel jeder Facette",
    "Films of measured layers, at the angle of every facet: slower and noisier, to compare with":
        "Stapel gemessener dünner Schichten, im Winkel jeder Facette: langsamer und mit mehr Rauschen, zum Vergleich",
    "Films of measured layers, clean and fast: the one to take first":
        "Stapel gemessener dünner Schichten, rauscharm und schnell: die erste Wahl",
    "Find a material by its name, its formula or any other name for it, and put it on the selected objects":
        "Findet ein Material nach Namen, Formel oder jedem anderen Namen und gibt es den gewählten Objekten",
    "Fingerprints":
        "Fingerabdrücke",
    "Fingerprints and wipe marks, for Roughness and Diffuse Color":
        "Fingerabdrücke und Wischspuren, für Rauheit und diffuse Farbe",
    "Finish":
        "Oberfläche",
    "Finish: {:s}":
        "Oberfläche: {:s}",
    "First Thickness":
        "Erste Dicke",
    "Fit":
        "Anpassung",
    "Fit Measured BRDF":
        "Gemessene BRDF anpassen",
    "Fit a model to a measured BRDF, put it in the material slot and save it as a preset of your own: .bsdf of RGL-EPFL, .binary of MERL, or points as text. Takes a few seconds; Esc stops it":
        "Passt ein Modell an eine gemessene BRDF an, setzt es in den Materialslot und speichert es als eigene Voreinstellung: .bsdf von RGL-EPFL, .binary von MERL oder Punkte als Text. Dauert einige Sekunden; Esc bricht ab",
    "Fitting {:s}: {:d} %   (Esc stops)":
        "{:s} wird angepasst: {:d} %   (Esc bricht ab)",
    "For exporters, not rendered":
        "Für Exporter, nicht gerendert",
    "Form":
        "Form",
    "Free over the angle, for colours that change with it; with two slopes at most":
        "Frei über dem Winkel, für Farben, die sich mit ihm ändern; mit höchstens zwei Steigungen",
    "Fresnel":
        "Fresnel",
    "Fresnel Ramp":
        "Fresnel-Verlauf",
    "Gamut":
        "Farbumfang",
    "Gaussian":
        "Gauß-Verteilung",
    "Gaussian c":
        "Gauß c",
    "Give a preset that you saved another name":
        "Gibt einer gespeicherten Voreinstellung einen anderen Namen",
    "Give this material another finish; what it is made of stays":
        "Gibt diesem Material eine andere Oberfläche; woraus es besteht, bleibt",
    "Glass and gems with the colours of the rainbow, each refracted by its own index":
        "Glas und Edelsteine mit den Farben des Regenbogens, jede mit eigener Brechzahl",
    "Glass, liquids and gems of one index of refraction, coloured by the way through them":
        "Glas, Flüssigkeiten und Edelsteine mit einer Brechzahl, gefärbt vom Weg durch sie hindurch",
    "Gradient":
        "Verlauf",
    "Greatest Thickness":
        "Größte Dicke",
    "Group":
        "Gruppe",
    "Hammered":
        "Gehämmert",
    "Headers":
        "Kopfleisten",
    "How many rms slopes the facets have":
        "Wie viele mittlere Steigungen die Facetten haben",
    "How the facets' slopes are distributed":
        "Wie die Steigungen der Facetten verteilt sind",
    "How the formula becomes a Cycles material":
        "Wie die Formel zu einem Cycles-Material wird",
    "IOR":
        "Brechzahl",
    "IOR Below":
        "IOR darunter",
    "Illuminant":
        "Lichtart",
    "Image Rows":
        "Bildzeilen",
    "Import Measurement":
        "Messung importieren",
    "In Object Mode select two meshes: the glass, and then the water":
        "Im Objektmodus zwei Netze auswählen: das Glas, danach das Wasser",
    "In Place":
        "An Ort und Stelle",
    "Inside, unchanged":
        "Innerhalb, unverändert",
    "Interference in the clear film is lost there.":
        "Interferenz im klaren Film geht dort verloren.",
    "Into a slot of its own; in Edit Mode for the selected faces":
        "In einen eigenen Slot; im Bearbeitungsmodus für die gewählten Flächen",
    "Into every material slot of every selected object":
        "In jeden Materialslot jedes gewählten Objekts",
    "Into the active material slot of every selected object":
        "In den aktiven Materialslot jedes gewählten Objekts",
    "Inwards":
        "Nach innen",
    "Keep colours outside of the gamut":
        "Behält Farben außerhalb des Farbumfangs",
    "Keep it among your own presets, with what it was fitted from":
        "Es unter den eigenen Voreinstellungen behalten, mit seiner Herkunft",
    "Large fields of view":
        "Große Sehfelder",
    "Last Thickness":
        "Letzte Dicke",
    "Layer":
        "Schicht",
    "Layer From a File":
        "Schicht aus einer Datei",
    "Layer From a File...":
        "Schicht aus einer Datei …",
    "Layer Thickness":
        "Schichtdicke",
    "Layer {place} of a stack needs n above 0 and k of at least 0 at every wavelength.":
        "Lage {place} eines Stapels braucht bei jeder Wellenlänge n über 0 und k von mindestens 0.",
    "Layered RGB OSL":
        "Layered RGB OSL",
    "Layered RGB Reference":
        "Layered RGB, Referenz",
    "Layered RGB Standard":
        "Layered RGB, Standard",
    "Layers":
        "Schichten",
    "Layers from the outside in, such as 'SiO2 0-1000 nm / Si'":
        "Schichten von außen nach innen, etwa 'SiO2 0-1000 nm / Si'",
    "Layers in Words":
        "Schichten in Worten",
    "Least Thickness":
        "Kleinste Dicke",
    "Leave":
        "Belassen",
    "Left out, as they take no materials or are linked: {:s}":
        "Ausgelassen, da sie keine Materialien nehmen oder verknüpft sind: {:s}",
    "Length":
        "Länge",
    "Light":
        "Licht",
    "Light and Gamut":
        "Licht und Farbumfang",
    "Light in which the material has its colour; D65 is daylight, and white in Blender":
        "Licht, in dem das Material seine Farbe hat; D65 ist Tageslicht und in Blender weiß",
    "Linear Rec.709, Blender's default":
        "Lineares Rec.709, Blenders Voreinstellung",
    "Lower Normal":
        "Untere Normale",
    "Make Local":
        "Lokal machen",
    "Make a material of one Principled BSDF that comes closest to this one, and put it in its place: for "
    "baking textures, for other engines and exporters. The material itself stays in the file":
        "Ein Material aus einem Principled BSDF machen, das diesem am nächsten kommt, und an seine Stelle "
        "setzen: zum Backen von Texturen, für andere Engines und Exporter. Das Material selbst bleibt in der "
        "Datei",
    "Make one face of two clear bodies that touch, as water does in a glass. Select the glass, then the water: the faces of the water on the glass get their material, and the glass's below them go":
        "Macht eine Fläche aus zweien, wo klare Körper sich berühren wie Wasser in einem Glas. Das Glas auswählen, dann das Wasser: die Flächen des Wassers am Glas bekommen ihr Material, die des Glases darunter verschwinden",
    "Make the active material itself over, wherever it is used":
        "Ändert das aktive Material selbst, wo immer es benutzt wird",
    "Make the active material slot the material that you saved":
        "Macht den aktiven Materialslot zum gespeicherten Material",
    "Make this linked or overridden material the file's own: changes in its library no longer arrive":
        "Dieses verknüpfte oder überschriebene Material zum eigenen der Datei machen: Änderungen in seiner "
        "Bibliothek kommen nicht mehr an",
    "Match Working Space":
        "An Arbeitsfarbraum anpassen",
    "Material":
        "Material",
    "Material Shelf":
        "Materialleiste",
    "Material: a preset's name, or a dataset such as main/Cu/Johnson. Type to search":
        "Material: Name einer Voreinstellung, oder ein Datensatz wie main/Cu/Johnson. Tippen sucht",
    "Matt, with an even, fine grain":
        "Matt, mit gleichmäßigem, feinem Korn",
    "Measured Material":
        "Gemessenes Material",
    "Measurement":
        "Messung",
    "Menus":
        "Menüs",
    "Metals, plastics and stone, clean and fast, in Cycles and in EEVEE: the one to take first":
        "Metalle, Kunststoffe und Stein, rauscharm und schnell, in Cycles und in EEVEE: die erste Wahl",
    "Model":
        "Modell",
    "Move the chosen layer inwards":
        "Die gewählte Schicht nach innen schieben",
    "Move the chosen layer outwards":
        "Die gewählte Schicht nach außen schieben",
    "Name a saved preset, and a new name with at least one letter":
        "Eine gespeicherte Voreinstellung nennen und einen neuen Namen mit mindestens einem Buchstaben",
    "Nearest":
        "Nächste",
    "New Materials Render by":
        "Neue Materialien rendern mit",
    "New Name":
        "Neuer Name",
    "New Slot":
        "Neuer Slot",
    "No face of {:s} lies on {:s} with its normal the other way: duplicate the wet faces of the one, flip their normals, and close them to the other":
        "Keine Fläche von {:s} liegt mit umgekehrter Normale auf {:s}: die nassen Flächen des einen verdoppeln, ihre Normalen umkehren und sie zum anderen schließen",
    "Nodes updated: {:d}":
        "Aktualisierte Nodes: {:d}",
    "Noise Detail":
        "Rauschdetail",
    "Noise Scale":
        "Rauschgröße",
    "Normal":
        "Normale",
    "OSL Standard":
        "OSL Standard",
    "OSL needs the CPU or OptiX: {:s} is shown in its place on this device":
        "OSL braucht die CPU oder OptiX: auf diesem Gerät wird stattdessen {:s} gezeigt",
    "Observer":
        "Beobachter",
    "Of a file that holds or can mean several things: which. Empty where its meaning is plain":
        "Bei einer Datei, die mehreres enthält oder bedeuten kann: welches. Leer, wo die Bedeutung klar ist",
    "Of {word!r} only the normal reflectance is known, and a stack needs n and k; choose another dataset.":
        "Von {word!r} ist nur die senkrechte Reflexion bekannt, ein Stapel braucht aber n und k; anderen "
        "Datensatz wählen.",
    "Open Shading Language is off: {:s} is shown in its place until you switch it on in the Render properties":
        "Open Shading Language ist aus: {:s} wird stattdessen gezeigt, bis es in den Render-Eigenschaften eingeschaltet wird",
    "Open a material in the Shader Editor first":
        "Erst ein Material im Shader-Editor öffnen",
    "Open all materials as pictures: each click puts one on the selected objects, until Esc. The first time this adds the library Facet & Film to your preferences":
        "Öffnet alle Materialien als Bilder: Jeder Klick gibt eines den gewählten Objekten, bis Esc. Beim ersten Mal "
        "kommt die Bibliothek Facet & Film in die Einstellungen",
    "Open an Asset Browser and choose the library {:s}: drag a material onto an object":
        "Einen Asset-Browser öffnen und die Bibliothek {:s} wählen: ein Material auf ein Objekt ziehen",
    "Outside":
        "Außen",
    "Outside IOR":
        "Brechzahl außen",
    "Outside: {:s}, channels moved by up to {:.3f}":
        "Außerhalb: {:s}, Kanäle um bis zu {:.3f} verschoben",
    "Outwards":
        "Nach außen",
    "Parallel streaks, and highlights drawn out across them":
        "Parallele Striche, und Glanzlichter quer zu ihnen gezogen",
    "Parallel streaks, for Roughness, Normal, Tangent and Diffuse Color":
        "Parallele Striche, für Rauheit, Normale, Tangente und diffuse Farbe",
    "Parameters":
        "Parameter",
    "Paste Measurement":
        "Messung einfügen",
    "Pits":
        "Löcher",
    "Place":
        "Ort",
    "Polished":
        "Poliert",
    "Preset":
        "Voreinstellung",
    "Preset or dataset":
        "Voreinstellung oder Datensatz",
    "Preset or dataset to compare":
        "Zu vergleichende Voreinstellung oder Datensatz",
    "Preset or dataset to compare with":
        "Voreinstellung oder Datensatz zum Vergleich",
    "Preset's Own":
        "Der Voreinstellung eigene",
    "Presets":
        "Voreinstellungen",
    "Principled Twin":
        "Principled-Zwilling",
    "Published Scale":
        "Veröffentlichte Skala",
    "Put this material on the selected objects. What you made by hand stays: the slot gets a new material":
        "Gibt den gewählten Objekten dieses Material. Was von Hand gemacht ist, bleibt: Der Slot bekommt ein neues "
        "Material",
    "Randomness":
        "Zufälligkeit",
    "Re-bake":
        "Neu backen",
    "Re-bake All Materials":
        "Alle Materialien neu backen",
    "Read As":
        "Gelesen als",
    "Read the Documents":
        "Dokumente lesen",
    "Realisation":
        "Umsetzung",
    "Reference":
        "Referenz",
    "Reflectance at normal incidence":
        "Reflexionsgrad bei senkrechtem Einfall",
    "Reflectance at normal incidence and F82 tint for red, green and blue":
        "Reflexionsgrad bei senkrechtem Einfall und F82-Tönung für Rot, Grün und Blau",
    "Refractive Index":
        "Brechungsindex",
    "Refractive Index n":
        "Brechungsindex n",
    "Refractive index and extinction for red, green and blue":
        "Brechungsindex und Extinktion für Rot, Grün und Blau",
    "Refractive index for red, green and blue":
        "Brechungsindex für Rot, Grün und Blau",
    "Remove":
        "Entfernen",
    "Remove Asset Library":
        "Asset-Bibliothek entfernen",
    "Remove the chosen layer":
        "Die gewählte Schicht entfernen",
    "Rename Preset":
        "Voreinstellung umbenennen",
    "Render every model and realisation in a second Blender, compare the pixels with the published formulas, and open the report. Takes one to five minutes; Esc stops it":
        "Rendert jedes Modell und jede Umsetzung in einem zweiten Blender, vergleicht die Pixel mit den veröffentlichten Formeln und öffnet den Bericht. Dauert eine bis fünf Minuten; Esc bricht ab",
    "Render this material by another realisation; every value and link that you set stays":
        "Rendert dieses Material mit einer anderen Umsetzung; alle Werte und Verbindungen bleiben",
    "Renders by":
        "Rendert mit",
    "Rotation":
        "Drehung",
    "Rough, 1982":
        "Rau, 1982",
    "Roughness":
        "Rauheit",
    "Rows":
        "Zeilen",
    "Runs in a second Blender, which Blender as a Python module lacks: run python -m addon verify":
        "Läuft in einem zweiten Blender, das Blender als Python-Modul fehlt: python -m addon verify aufrufen",
    "Samples":
        "Messpunkte",
    "Sampling Width":
        "Abtastbreite",
    "Sandblasted":
        "Sandgestrahlt",
    "Satin":
        "Seidenglanz",
    "Save Preset":
        "Voreinstellung speichern",
    "Save as Preset":
        "Als Voreinstellung speichern",
    "Save the active material under a name of your own, or delete a saved one":
        "Speichert das aktive Material unter eigenem Namen oder löscht ein gespeichertes",
    "Say what this face of a clear body is against: air, or another clear material, as water in a glass is. In Edit Mode the selected faces get a material of their own":
        "Sagt, woran diese Fläche eines klaren Körpers liegt: an Luft oder an einem anderen klaren Material, wie Wasser in einem Glas. Im Bearbeitungsmodus bekommen die ausgewählten Flächen ein eigenes Material",
    "Scale":
        "Skalieren",
    "Scene Scale":
        "Maßstab der Szene",
    "Scene-linear space that the colours are written in":
        "Szenenlinearer Farbraum, in dem die Farben geschrieben werden",
    "Scratch Roughness":
        "Rauheit der Kratzer",
    "Scratched":
        "Zerkratzt",
    "Scratches and hairlines, for Roughness, Normal and Diffuse Color":
        "Kratzer und Haarlinien, für Rauheit, Normale und diffuse Farbe",
    "Search":
        "Suchen",
    "Search Facet & Film Materials":
        "Facet & Film: Materialien suchen",
    "See-through":
        "Durchsichtig",
    "See-through Shadows":
        "Durchscheinende Schatten",
    "Select a group node of Facet & Film first":
        "Erst einen Gruppen-Node von Facet & Film auswählen",
    "Select a group of Facet & Film, or add one: Add, Facet & Film":
        "Eine Gruppe von Facet & Film auswählen oder hinzufügen: Hinzufügen, Facet & Film",
    "Select an object first: the material goes into its active material slot":
        "Zuerst ein Objekt auswählen: Das Material kommt in dessen aktiven Materialslot",
    "Select the object whose face it is":
        "Das Objekt auswählen, dessen Fläche es ist",
    "Selected Node":
        "Gewählter Node",
    "Several slopes become one of the same rms.":
        "Aus mehreren Steigungen wird eine mit demselben Effektivwert.",
    "Shadows and caustics are the other program's own.":
        "Schatten und Kaustik sind die des anderen Programms.",
    "Shallow dimples side by side, each with its own highlight":
        "Flache Dellen nebeneinander, jede mit eigenem Glanzlicht",
    "Shallow dimples, for Roughness and Normal":
        "Flache Dellen, für Rauheit und Normale",
    "Shelf":
        "Leiste",
    "Show F0, F82 and how many CIEDE2000 typed-in values or a material lie from a measured material":
        "Zeigt F0, F82 und um wie viel CIEDE2000 eingegebene Werte oder ein Material von einem gemessenen abweichen",
    "Show all measurements of the same material side by side: published values differ from lab to lab":
        "Zeigt alle Messungen desselben Materials nebeneinander: Veröffentlichte Werte unterscheiden sich von Labor zu Labor",
    "Show or hide a shelf of all materials along the 3D Viewport, to click on or to drag onto objects":
        "Zeigt oder verbirgt eine Leiste aller Materialien an der 3D-Ansicht, zum Anklicken oder Ziehen auf Objekte",
    "Sidebar":
        "Seitenleiste",
    "Slope Ratio 2":
        "Steigungsverhältnis 2",
    "Slope Ratio 3":
        "Steigungsverhältnis 3",
    "Slope Ratio 4":
        "Steigungsverhältnis 4",
    "Slopes":
        "Steigungen",
    "Small fields of view; what displays are calibrated for":
        "Kleine Sehfelder; darauf sind Bildschirme kalibriert",
    "Smooth, with clear reflections that are soft at their edges":
        "Glatt, mit klaren Spiegelungen, deren Ränder weich sind",
    "Smooth, with deep scratches and hairlines in all directions":
        "Glatt, mit tiefen Kratzern und Haarlinien in allen Richtungen",
    "Smooth, with fingerprints and the marks of wiping":
        "Glatt, mit Fingerabdrücken und Wischspuren",
    "Smudge Roughness":
        "Rauheit der Schmierflecken",
    "Smudged":
        "Verschmiert",
    "Softness":
        "Weichheit",
    "Specular":
        "Glanz",
    "Standard":
        "Standard",
    "Standard as an OSL script: needs Open Shading Language switched on":
        "Standard als OSL-Skript: Open Shading Language muss eingeschaltet sein",
    "Standard; Dispersive for diamond, lead crystal and what else is known by its rainbow":
        "Standard; Dispersiv bei Diamant, Bleikristall und was sonst durch seinen Regenbogen bekannt ist",
    "Stopped: no material was changed":
        "Abgebrochen: Kein Material wurde geändert",
    "Stopped: nothing was fitted":
        "Abgebrochen: Es wurde nichts angepasst",
    "Streaks in circles, as from a lathe or on the foot of a pan":
        "Striche in Kreisen, wie von der Drehbank oder auf einem Topfboden",
    "Streaks in circles, for Roughness, Normal, Tangent and Diffuse Color":
        "Striche in Kreisen, für Rauheit, Normale, Tangente und diffuse Farbe",
    "Substrate":
        "Träger",
    "Substrate From a File...":
        "Träger aus einer Datei …",
    "Switch Realisation":
        "Umsetzung wechseln",
    "Table":
        "Tabelle",
    "Take a measurement of your own as a layer: a file of n and k":
        "Eine eigene Messung als Schicht nehmen: eine Datei mit n und k",
    "Take the library off the Asset Browser again, and with it the pictures to choose from; materials stay":
        "Nimmt die Bibliothek wieder aus dem Asset-Browser und mit ihr die Bilder zum Auswählen; Materialien bleiben",
    "Tangent":
        "Tangente",
    "Tarnish":
        "Anlauf",
    "Temperature":
        "Temperatur",
    "Texture":
        "Textur",
    "Texture Share":
        "Texturanteil",
    "The asset library {:s} was added to your preferences; the extension's own take it out again":
        "Die Asset-Bibliothek {:s} steht jetzt in den Einstellungen; die der Erweiterung nehmen sie wieder heraus",
    "The chosen layer":
        "Die gewählte Schicht",
    "The coarse, dull skin of a sand mould, with pits":
        "Die grobe, matte Haut einer Sandform, mit Löchern",
    "The colour inside that looks most alike, by CIEDE2000":
        "Die Farbe innerhalb, die nach CIEDE2000 am ähnlichsten aussieht",
    "The devices that are switched on under System, Cycles Render Devices":
        "Die unter System, Cycles-Rendergeräte eingeschalteten Geräte",
    "The facets' distribution becomes GGX, whose highlights have wider tails.":
        "Aus der Verteilung der Facetten wird GGX, deren Glanzlichter breiter auslaufen.",
    "The file {file!r} cannot be read.":
        "Die Datei {file!r} lässt sich nicht lesen.",
    "The film's colors over the angle become two: face on and at 82°.":
        "Aus den Farben des Films über den Winkel werden zwei: von vorn und bei 82°.",
    "The films come to {optical:.0f} nm of n times thickness, and interference is calculated to {most:.0f}; "
    "make them thinner, or what is thick the layer below.":
        "Die Schichten haben zusammen {optical:.0f} nm aus n mal Dicke, und Interferenz wird bis {most:.0f} "
        "gerechnet; dünner machen, oder das Dicke als unterste Lage nehmen.",
    "The folder of {file!r} does not exist; make it first, or name another.":
        "Den Ordner von {file!r} gibt es nicht; erst anlegen, oder einen anderen nennen.",
    "The greatest thickness in nanometres":
        "Die größte Dicke in Nanometern",
    "The index of refraction is lost there: 1.5 is taken.":
        "Die Brechzahl geht dort verloren: es gilt 1,5.",
    "The index {text} needs n above 0 and k of at least 0 from 360 to 780 nm.":
        "Die Brechzahl {text} braucht von 360 bis 780 nm n über 0 und k von mindestens 0.",
    "The library is in your preferences already":
        "Die Bibliothek steht schon in den Einstellungen",
    "The library is not in the preferences":
        "Die Bibliothek steht nicht in den Einstellungen",
    "The library {:s} is no longer shown":
        "Die Bibliothek {:s} wird nicht mehr gezeigt",
    "The measured points: wavelength_nm, n, k":
        "Die gemessenen Punkte: wavelength_nm, n, k",
    "The medium outside is a number from 1 to 4 or a clear material, such as 1.33 or 'water', not {value!r}.":
        "Das Medium außen ist eine Zahl von 1 bis 4 oder ein klares Material, etwa 1.33 oder 'water', nicht {value!r}.",
    "The medium outside is named by its index, a preset or a dataset; {medium} is a measurement of your own: give its index.":
        "Das Medium außen heißt nach seinem Index, einer Voreinstellung oder einem Datensatz; {medium} ist eine eigene Messung: den Index angeben.",
    "The preset to rename":
        "Die umzubenennende Voreinstellung",
    "The preset {file!r} cannot be read.":
        "Die Voreinstellung {file!r} lässt sich nicht lesen.",
    "The processor":
        "Der Prozessor",
    "The published formula as an OSL script: needs Open Shading Language switched on in the Render properties, on the CPU or OptiX; EEVEE shows Standard":
        "Die veröffentlichte Formel als OSL-Skript: Open Shading Language muss in den Render-Eigenschaften "
        "eingeschaltet sein, auf CPU oder OptiX; EEVEE zeigt Standard",
    "The published formula itself, on every device: slower and noisier, to compare with; EEVEE shows Standard":
        "Die veröffentlichte Formel selbst, auf jedem Gerät: langsamer und mit mehr Rauschen, zum Vergleich; EEVEE "
        "zeigt Standard",
    "The published formula of Cook and Torrance 1982 as an OSL script, to read beside the paper":
        "Die veröffentlichte Formel von Cook und Torrance 1982 als OSL-Skript, neben dem Aufsatz zu lesen",
    "The published formula of Cook and Torrance 1982 itself: slower and noisier, to compare with":
        "Die veröffentlichte Formel von Cook und Torrance 1982 selbst: langsamer und mit mehr Rauschen, zum Vergleich",
    "The published formula of Granier and Heidrich 2003 as an OSL script, to read beside the paper":
        "Die veröffentlichte Formel von Granier und Heidrich 2003 als OSL-Skript, neben dem Aufsatz zu lesen",
    "The published formula of Granier and Heidrich 2003 itself: slower and noisier, to compare with":
        "Die veröffentlichte Formel von Granier und Heidrich 2003 selbst: langsamer und mit mehr Rauschen, zum Vergleich",
    "The rough finish of the paper's copper vase":
        "Die raue Oberfläche der Kupfervase aus der Veröffentlichung",
    "The same layers as one line, such as 'SiO2 0-1000 nm / Si': it can be copied and pasted":
        "Dieselben Schichten als eine Zeile, etwa 'SiO2 0-1000 nm / Si': sie lässt sich kopieren und einfügen",
    "The scene-linear space of this file":
        "Der szenenlineare Farbraum dieser Datei",
    "The scene-linear space of this file has no three primaries; choose another OpenColorIO "
    "configuration, or name a space.":
        "Der szenenlineare Farbraum dieser Datei hat keine drei Primärfarben; wähle eine andere "
        "OpenColorIO-Konfiguration oder nenne einen Farbraum.",
    "The second Blender ended with status {:d}: {:s}":
        "Das zweite Blender endete mit Status {:d}: {:s}",
    "The shader {shader} does not compile: {why}":
        "Der Shader {shader} lässt sich nicht übersetzen: {why}",
    "The shelf stands in a 3D Viewport in Object Mode":
        "Die Leiste steht in einer 3D-Ansicht im Objektmodus",
    "The simplest of the others of which no other comes clearly closer":
        "Die einfachste der übrigen, der keine andere deutlich näher kommt",
    "The skin of a sand mould, for Roughness and Normal":
        "Die Haut einer Sandform, für Rauheit und Normale",
    "The thickness is a range, from which the material's own, a texture or a gradient take theirs":
        "Die Dicke ist ein Bereich, aus dem die des Materials, einer Textur oder eines Verlaufs stammt",
    "The thickness must be from {low:g} to {high:g} nm, as the stack says; it is {given:g}.":
        "Die Dicke muss von {low:g} bis {high:g} nm reichen, wie der Stapel sagt; sie ist {given:g}.",
    "The thickness of a film must be at least 0 nm; that of layer {place} is {thickness:g}.":
        "Die Dicke einer Schicht muss mindestens 0 nm sein; die von Lage {place} ist {thickness:g}.",
    "The thickness of {word!r} must be from 0 nm on, the lower end of a range first; it is {low:g} to {high:g} nm.":
        "Die Dicke von {word!r} muss mindestens 0 nm sein, das untere Ende zuerst; sie ist {low:g} bis {high:g} nm.",
    "The verification was stopped; there is no report":
        "Die Prüfung wurde abgebrochen; es gibt keinen Bericht",
    "Their Finish":
        "Ihre Oberfläche",
    "There is a preset called {:s} already":
        "Es gibt schon eine Voreinstellung namens {:s}",
    "There is no material of Facet & Film called {name!r}.":
        "Es gibt kein Material von Facet & Film namens {name!r}.",
    "There is no material {material!r} in this file any more.":
        "In dieser Datei gibt es das Material {material!r} nicht mehr.",
    "Thickness":
        "Dicke",
    "Thickness in nanometres of the oxide that a voltage grows on a metal":
        "Dicke des Oxids in Nanometern, das eine Spannung auf einem Metall wachsen lässt",
    "Thickness in nanometres of the oxide that heat grows on a metal":
        "Dicke des Oxids in Nanometern, das Hitze auf einem Metall wachsen lässt",
    "Thickness in nanometres that varies by noise, a gradient or a texture":
        "Dicke in Nanometern, die durch Rauschen, einen Verlauf oder eine Textur wechselt",
    "Thickness in nanometres that varies over the surface, and the lower normal tilted along it":
        "Dicke in Nanometern, die über die Fläche wechselt, und die danach geneigte untere Normale",
    "Thickness in nanometres; where it varies, the least":
        "Dicke in Nanometern; wo sie veränderlich ist, die kleinste",
    "Thin Walled":
        "Dünnwandig",
    "This Blender is built without OSL: take Reference or Standard, which render the same material":
        "Dieses Blender ist ohne OSL gebaut: Referenz oder Standard nehmen, die dasselbe Material rendern",
    "This Blender lacks its module oslquery, which OSL scripts need: take Reference or Standard":
        "Diesem Blender fehlt sein Modul oslquery, das OSL-Skripte brauchen: Referenz oder Standard nehmen",
    "This engine renders Standard in its place: for this realisation choose Cycles in the Render properties":
        "Diese Engine rendert stattdessen Standard: Für diese Umsetzung Cycles in den Render-Eigenschaften wählen",
    "This file has no material with a measurement: bake a preset first":
        "Diese Datei hat kein Material mit einer Messung: Erst eine Voreinstellung backen",
    "This file is no preset of Facet & Film.":
        "Diese Datei ist keine Voreinstellung von Facet & Film.",
    "This material is the file's own already":
        "Dieses Material gehört der Datei schon",
    "This model has no roughness that a finish could vary":
        "Dieses Modell hat keine Rauheit, die eine Oberfläche verändern könnte",
    "Time":
        "Zeit",
    "Tint":
        "Tönung",
    "To":
        "Nach",
    "Towards grey of the same luminance, until inside: the 1982 paper's way":
        "Zum Grau gleicher Leuchtdichte hin, bis innerhalb: der Weg der Veröffentlichung von 1982",
    "Under this OpenColorIO configuration pixels do not come back from an OpenEXR file as they were "
    "rendered, so nothing can be verified: use one that has a role for data, or start Blender without it.":
        "Mit dieser OpenColorIO-Konfiguration kommen Pixel nicht so aus einer OpenEXR-Datei zurück, wie sie "
        "gerendert wurden, also lässt sich nichts prüfen: eine mit einer Rolle für Daten nehmen oder Blender "
        "ohne sie starten.",
    "Unevenness":
        "Ungleichmäßigkeit",
    "Update Materials":
        "Materialien aktualisieren",
    "Usual":
        "Üblich",
    "Varies":
        "Veränderlich",
    "Vector":
        "Vektor",
    "Verdict":
        "Urteil",
    "Verify Against the Formulas":
        "Mit den Formeln prüfen",
    "Verify on CPU":
        "Auf der CPU prüfen",
    "Verify on GPU":
        "Auf der GPU prüfen",
    "Verifying {:s}":
        "Prüfung: {:s}",
    "Verifying: starting a second Blender …":
        "Prüfung: startet ein zweites Blender …",
    "Voltage":
        "Spannung",
    "Wavelengths":
        "Wellenlängen",
    "Wear":
        "Abnutzung",
    "Weight 1":
        "Gewicht 1",
    "Weight 2":
        "Gewicht 2",
    "Weight 3":
        "Gewicht 3",
    "Weight 4":
        "Gewicht 4",
    "What is below all layers":
        "Was unter allen Schichten liegt",
    "What is below all layers, without a thickness: a metal, a glass, air for a soap film":
        "Was unter allen Schichten liegt, ohne Dicke: ein Metall, ein Glas, Luft bei einer Seifenhaut",
    "What is on the face's other side":
        "Was auf der anderen Seite der Fläche ist",
    "What is outside a stack must not absorb, and this has k up to {k:.2g}; name something clear, such as "
    "air or water.":
        "Was außerhalb eines Stapels ist, darf nicht absorbieren, und dies hat k bis {k:.2g}; etwas Klares "
        "nennen, etwa Luft oder Wasser.",
    "What is plugged into {:s} stays behind":
        "Was an {:s} angeschlossen ist, bleibt zurück",
    "What is seen through arrives opaque there.":
        "Durchsichtiges kommt dort undurchsichtig an.",
    "What the layer is of: a formula such as SiO2, a preset, a dataset, a file, or an index such as 1.38 or 2.5+0.1i. Type to search":
        "Woraus die Schicht ist: eine Formel wie SiO2, eine Voreinstellung, ein Datensatz, eine Datei oder "
        "eine Brechzahl wie 1.38 oder 2.5+0.1i. Zum Suchen tippen",
    "What the layers are in: air, or something clear such as water":
        "Worin die Schichten sind: Luft oder etwas Klares wie Wasser",
    "What the reflectance F may be":
        "Was der Reflexionsgrad F sein darf",
    "What the surface is in: air, an index such as 1.33, or a clear material such as water":
        "Worin die Oberfläche liegt: Luft, ein Index wie 1.33 oder ein klares Material wie Wasser",
    "What this material does with light has no counterpart there: its color and gloss at a glance remain.":
        "Was dieses Material mit Licht macht, hat dort kein Gegenstück: Es bleiben Farbe und Glanz auf einen Blick.",
    "What to call it":
        "Wie sie heißen soll",
    "What to compare":
        "Was verglichen wird",
    "What to do with colours that the working space cannot hold":
        "Was mit Farben geschieht, die der Arbeitsfarbraum nicht fasst",
    "What to do with the list":
        "Was mit der Liste geschieht",
    "What to render the probes on":
        "Worauf die Proben gerendert werden",
    "What to write":
        "Was geschrieben wird",
    "What was done to the surface":
        "Wie die Oberfläche bearbeitet wurde",
    "Where the material goes":
        "Wohin das Material kommt",
    "Where to Find It":
        "Wo es zu finden ist",
    "Which group to add":
        "Welche Gruppe hinzugefügt wird",
    "Which layer is of it":
        "Welche Schicht daraus ist",
    "Which material to apply":
        "Welches Material angewandt wird",
    "Whitening":
        "Aufhellung",
    "Width":
        "Breite",
    "Wipe Marks":
        "Wischspuren",
    "Workbench shows the viewport colour only: choose Cycles in the Render properties":
        "Workbench zeigt nur die Ansichtsfarbe: In den Render-Eigenschaften Cycles wählen",
    "Working Space":
        "Arbeitsfarbraum",
    "Worn Edges":
        "Abgenutzte Kanten",
    "Write the active material as its node holds it now: JSON, CSV or MaterialX":
        "Schreibt das aktive Material, wie sein Node es jetzt enthält: JSON, CSV oder MaterialX",
    "Wrote {:s}":
        "{:s} geschrieben",
    "You have saved no preset yet":
        "Es ist noch keine Voreinstellung gespeichert",
    "a space of its own":
        "einem eigenen Farbraum",
    "alike":
        "gleich",
    "average daylight (superseded), 6774 K":
        "mittleres Tageslicht (überholt), 6774 K",
    "broadband fluorescent, D50 simulator, 5000 K":
        "Breitband-Leuchtstofflampe, D50-Simulator, 5000 K",
    "broadband fluorescent, D65 simulator, 6500 K":
        "Breitband-Leuchtstofflampe, D65-Simulator, 6500 K",
    "broadband fluorescent, cool white deluxe, 4150 K":
        "Breitband-Leuchtstofflampe, Kaltweiß de Luxe, 4150 K",
    "colour enhanced high pressure sodium lamp, 2510 K":
        "farbverbesserte Natriumdampf-Hochdrucklampe, 2510 K",
    "cool white fluorescent, 4230 K":
        "Leuchtstofflampe, Kaltweiß, 4230 K",
    "dataset {dataset!r} is unknown. Datasets are named 'shelf/book/page', as refractiveindex.info does; a search finds them.":
        "Datensatz {dataset!r} ist unbekannt. Datensätze heißen 'Regal/Buch/Seite' wie bei refractiveindex.info; die Suche findet sie.",
    "dataset {dataset!r} is unknown; did you mean {near}? Datasets are named 'shelf/book/page', as refractiveindex.info does; a search finds them.":
        "Datensatz {dataset!r} ist unbekannt; war {near} gemeint? Datensätze heißen 'Regal/Buch/Seite' wie bei refractiveindex.info; die Suche findet sie.",
    "daylight fluorescent, 6350 K":
        "Leuchtstofflampe, Tageslicht, 6350 K",
    "daylight fluorescent, 6430 K":
        "Leuchtstofflampe, Tageslicht, 6430 K",
    "daylight, 5000 K":
        "Tageslicht, 5000 K",
    "daylight, 5500 K":
        "Tageslicht, 5500 K",
    "daylight, 6000 K":
        "Tageslicht, 6000 K",
    "daylight, 6500 K":
        "Tageslicht, 6500 K",
    "deluxe fluorescent, 2900 K":
        "De-Luxe-Leuchtstofflampe, 2900 K",
    "deluxe fluorescent, 4090 K":
        "De-Luxe-Leuchtstofflampe, 4090 K",
    "deluxe fluorescent, 4890 K":
        "De-Luxe-Leuchtstofflampe, 4890 K",
    "direct sunlight at noon (superseded), 4874 K":
        "direktes Sonnenlicht am Mittag (überholt), 4874 K",
    "equal energy":
        "energiegleich",
    "fair":
        "mäßig",
    "finish":
        "Oberfläche",
    "fluorescent, D65 simulator, 6510 K":
        "Leuchtstofflampe, D65-Simulator, 6510 K",
    "good":
        "gut",
    "halophosphate fluorescent, 2930 K":
        "Halophosphat-Leuchtstofflampe, 2930 K",
    "halophosphate fluorescent, 3970 K":
        "Halophosphat-Leuchtstofflampe, 3970 K",
    "halophosphate fluorescent, 6280 K":
        "Halophosphat-Leuchtstofflampe, 6280 K",
    "high pressure metal halide lamp, 3140 K":
        "Halogen-Metalldampflampe, 3140 K",
    "high pressure metal halide lamp, 4000 K":
        "Halogen-Metalldampflampe, 4000 K",
    "high pressure metal halide lamp, 4040 K":
        "Halogen-Metalldampflampe, 4040 K",
    "high pressure sodium lamp, 1960 K":
        "Natriumdampf-Hochdrucklampe, 1960 K",
    "incandescent lamp, 2856 K":
        "Glühlampe, 2856 K",
    "indoor daylight, 5100 K":
        "Tageslicht im Innenraum, 5100 K",
    "indoor daylight, 6600 K":
        "Tageslicht im Innenraum, 6600 K",
    "it said nothing":
        "es sagte nichts",
    "light white fluorescent, 4150 K":
        "Leuchtstofflampe, Hellweiß, 4150 K",
    "multi-band fluorescent, 2980 K":
        "Mehrbanden-Leuchtstofflampe, 2980 K",
    "multi-band fluorescent, 3900 K":
        "Mehrbanden-Leuchtstofflampe, 3900 K",
    "multi-band fluorescent, 5040 K":
        "Mehrbanden-Leuchtstofflampe, 5040 K",
    "n and k":
        "n und k",
    "name must be a text with at least one letter, not {text!r}.":
        "Der Name muss ein Text mit mindestens einem Buchstaben sein, nicht {text!r}.",
    "north sky daylight, 7500 K":
        "Tageslicht des Nordhimmels, 7500 K",
    "preset":
        "Voreinstellung",
    "preset {preset!r} is unknown; what fits these words: {found}.":
        "Voreinstellung {preset!r} ist unbekannt; zu diesen Wörtern passt: {found}.",
    "stack must be layers from the outside in, such as 'SiO2 0-1000 nm / Si', not {value!r}.":
        "stack muss Schichten von außen nach innen nennen, etwa 'SiO2 0-1000 nm / Si', nicht {value!r}.",
    "thickness_range must be (least, greatest) in nm, not ({least:g}, {greatest:g}).":
        "thickness_range muss (kleinste, größte) Dicke in nm sein, nicht ({least:g}, {greatest:g}).",
    "this model cannot, because away from its highlights it is not evenly diffuse, as where fibres or flakes send light back":
        "dieses Modell kann es nicht, denn abseits der Glanzlichter ist es nicht gleichmäßig matt, wie wo Fasern oder Plättchen Licht zurückwerfen",
    "this model cannot, because its colour changes with the angle in another way than one Fresnel term on facets does":
        "dieses Modell kann es nicht, denn die Farbe ändert sich mit dem Winkel anders als ein Fresnel-Term auf Facetten",
    "this model cannot, because its highlights have another shape than facets of a few slopes make, as those of flakes":
        "dieses Modell kann es nicht, denn die Glanzlichter haben eine andere Form als die von Facetten weniger Steigungen, wie bei Plättchen",
    "this model cannot, because towards grazing it reflects otherwise than facets do":
        "dieses Modell kann es nicht, denn streifend reflektiert es anders als Facetten",
    "three-band fluorescent, 2980 K":
        "Dreibanden-Leuchtstofflampe, 2980 K",
    "three-band fluorescent, 3000 K":
        "Dreibanden-Leuchtstofflampe, 3000 K",
    "three-band fluorescent, 4000 K":
        "Dreibanden-Leuchtstofflampe, 4000 K",
    "three-band fluorescent, 4010 K":
        "Dreibanden-Leuchtstofflampe, 4010 K",
    "three-band fluorescent, 4850 K":
        "Dreibanden-Leuchtstofflampe, 4850 K",
    "three-band fluorescent, 5000 K":
        "Dreibanden-Leuchtstofflampe, 5000 K",
    "three-band fluorescent, 5850 K":
        "Dreibanden-Leuchtstofflampe, 5850 K",
    "warm white fluorescent, 2940 K":
        "Leuchtstofflampe, Warmweiß, 2940 K",
    "white LED, blue with phosphor, 2730 K":
        "weiße LED, Blau mit Leuchtstoff, 2730 K",
    "white LED, blue with phosphor, 3000 K":
        "weiße LED, Blau mit Leuchtstoff, 3000 K",
    "white LED, blue with phosphor, 4100 K":
        "weiße LED, Blau mit Leuchtstoff, 4100 K",
    "white LED, blue with phosphor, 5110 K":
        "weiße LED, Blau mit Leuchtstoff, 5110 K",
    "white LED, blue with phosphor, 6600 K":
        "weiße LED, Blau mit Leuchtstoff, 6600 K",
    "white LED, blue with phosphor, and red, 2850 K":
        "weiße LED, Blau mit Leuchtstoff, und Rot, 2850 K",
    "white LED, red, green and blue, 2840 K":
        "weiße LED, Rot, Grün und Blau, 2840 K",
    "white LED, violet with phosphor, 2720 K":
        "weiße LED, Violett mit Leuchtstoff, 2720 K",
    "white LED, violet with phosphor, 4070 K":
        "weiße LED, Violett mit Leuchtstoff, 4070 K",
    "white fluorescent, 3450 K":
        "Leuchtstofflampe, Weiß, 3450 K",
    "{:d} lie below them in part: cut {:s} where the common face ends":
        "{:d} liegen nur zum Teil darunter: {:s} dort schneiden, wo die gemeinsame Fläche endet",
    "{:d} materials baked again":
        "{:d} Materialien neu gebacken",
    "{:d} objects":
        "{:d} Objekte",
    "{:d} used, {:d} left out":
        "{:d} verwendet, {:d} ausgelassen",
    "{:s} applied":
        "{:s} angewandt",
    "{:s} baked from {:s}: largest CIEDE2000 of the fit {:.2f}":
        "{:s} aus {:s} gebacken: größter CIEDE2000 der Anpassung {:.2f}",
    "{:s} fitted, CIEDE2000 {:.2f} on average: {:s}":
        "{:s} angepasst, CIEDE2000 im Mittel {:.2f}: {:s}",
    "{:s} has no clear material: give it one first, such as glass or water":
        "{:s} hat kein klares Material: zuerst eines geben, etwa Glas oder Wasser",
    "{:s} is linked: update it in {:s}":
        "{:s} ist verknüpft: in {:s} aktualisieren",
    "{:s} is the file's own now":
        "{:s} gehört jetzt der Datei",
    "{:s} on {:s}":
        "{:s} auf {:s}",
    "{:s} renders by {:s}":
        "{:s} rendert mit: {:s}",
    "{:s} takes no materials: select a mesh, curve, surface, text or volume":
        "{:s} nimmt keine Materialien: ein Mesh, eine Kurve, Fläche, Text oder ein Volumen auswählen",
    "{:s} was baked for {:s}, but this file's working space is {:s}: its colors are off":
        "{:s} wurde für {:s} gebacken, der Arbeitsfarbraum dieser Datei ist aber {:s}: seine Farben stimmen nicht",
    "{:s} was edited by hand and stays as it is":
        "{:s} wurde von Hand geändert und bleibt, wie es ist",
    "{:s} was made by a newer Facet & Film: install that one to change it":
        "{:s} stammt von einem neueren Facet & Film: dieses installieren, um es zu ändern",
    "{:s}: finish {:s}":
        "{:s}: Oberfläche {:s}",
    "{:s}: version {:d}, now {:d}":
        "{:s}: Version {:d}, jetzt {:d}",
    "{:s}: {:.1f} CIEDE2000 from {:s} on average over the angle":
        "{:s}: im Mittel über den Winkel {:.1f} CIEDE2000 von {:s}",
    "{:s}: {:d} faces of {:s}; {:d} faces of {:s} below them went":
        "{:s}: {:d} Flächen von {:s}; {:d} Flächen von {:s} darunter sind fort",
    "{dataset!r} is no dataset of the database; name one, or a material of it.":
        "{dataset!r} ist kein Datensatz der Datenbank; einen nennen oder ein Material daraus.",
    "{file!r} cannot be written: {why}; name another place.":
        "{file!r} lässt sich nicht schreiben: {why}; bitte einen anderen Ort nennen.",
    "{file!r} has a heading that does not name theta_i, phi_i, theta_o, phi_o and a column for every number.":
        "{file!r} hat eine Kopfzeile, die nicht theta_i, phi_i, theta_o, phi_o und zu jeder Zahl eine Spalte nennt.",
    "{file!r} has tables of the wrong dimensions: download it again.":
        "{file!r} hat Tabellen mit falschen Abmessungen: bitte neu herunterladen.",
    "{file!r} has {count} columns without a heading: name them, as in theta_i phi_i theta_o phi_o 450 550 650.":
        "{file!r} hat {count} Spalten ohne Kopfzeile: bitte benennen, wie in theta_i phi_i theta_o phi_o 450 550 650.",
    "{file!r} has {count} usable points; a fit needs {fewest}, and 400 where they are noisy.":
        "{file!r} hat {count} brauchbare Punkte; eine Anpassung braucht {fewest}, bei Rauschen 400.",
    "{file!r} has {sizes} entries; a file of the MERL database has 90 × 90 × 180.":
        "{file!r} hat {sizes} Einträge; eine Datei der MERL-Datenbank hat 90 × 90 × 180.",
    "{file!r} holds no measured BRDF: take .bsdf of RGL-EPFL, .binary of MERL, or a text of points, each θi φi θo φo and red green blue.":
        "{file!r} enthält keine gemessene BRDF: bitte .bsdf von RGL-EPFL, .binary von MERL oder einen Text von Punkten nehmen, je θi φi θo φo und Rot Grün Blau.",
    "{file!r} holds no value above 0: there is nothing to fit.":
        "{file!r} enthält keinen Wert über 0: Es gibt nichts anzupassen.",
    "{file!r} holds spectra: take the file of the same material that ends in _rgb.bsdf.":
        "{file!r} enthält Spektren: bitte die Datei desselben Materials nehmen, die auf _rgb.bsdf endet.",
    "{file!r} holds values that are no numbers (NaN or infinite): download it again.":
        "{file!r} enthält Werte, die keine Zahlen sind (NaN oder unendlich): bitte neu herunterladen.",
    "{file!r} is a Git LFS pointer, not the file itself: fetch it with git lfs pull.":
        "{file!r} ist ein Verweis von Git LFS, nicht die Datei selbst: bitte mit git lfs pull holen.",
    "{file!r} is a folder; name a file in it.":
        "{file!r} ist ein Ordner; bitte eine Datei darin nennen.",
    "{file!r} is a web page, not a measurement: download the file that it links to.":
        "{file!r} ist eine Webseite und keine Messung: bitte die Datei herunterladen, auf die sie verweist.",
    "{file!r} is anisotropic: it reflects otherwise when it is turned, which the fit does not know; take an isotropic material.":
        "{file!r} ist anisotrop: Es reflektiert gedreht anders, was die Anpassung nicht kennt; bitte ein isotropes Material nehmen.",
    "{file!r} is being written already; remove {aside!r} if it is not.":
        "{file!r} wird schon geschrieben; wenn nicht, {aside!r} entfernen.",
    "{file!r} is damaged or ends too early: download it again.":
        "{file!r} ist beschädigt oder endet zu früh: bitte neu herunterladen.",
    "{file!r} is larger than half a gigabyte, which no measured BRDF is.":
        "{file!r} ist größer als ein halbes Gigabyte; das ist keine gemessene BRDF.",
    "{file!r} is no BRDF of the RGL-EPFL database: it lacks some of its tables.":
        "{file!r} ist keine BRDF der RGL-EPFL-Datenbank: Es fehlen einige ihrer Tabellen.",
    "{file!r} is protected or no ordinary file; name another.":
        "{file!r} ist geschützt oder keine gewöhnliche Datei; bitte eine andere nennen.",
    "{file!r} names its values neither red, green and blue nor by wavelengths in nm that reach from 450 to 650.":
        "{file!r} benennt seine Werte weder rot, grün und blau noch nach Wellenlängen in nm, die von 450 bis 650 reichen.",
    "{material} absorbs light, so it cannot be the medium outside; name a clear one, such as 'water', or its index, such as 1.33.":
        "{material} absorbiert Licht und kann nicht das Medium außen sein; ein klares nennen, etwa 'water', oder dessen Brechzahl, etwa 1.33.",
    "{material} holds no measurement: bake a measured preset first.":
        "{material} enthält keine Messung: erst eine gemessene Voreinstellung backen.",
    "{material} is a library override, whose nodes and slots belong to another file: make it local first (Object, Relations, Make Local)":
        "{material} ist eine Bibliotheksüberschreibung, deren Nodes und Slots einer anderen Datei gehören: erst lokal machen (Objekt, Relationen, Lokal machen)",
    "{material} is known by its reflectance in air alone: none in another medium follows; take data of n and k.":
        "Von {material} ist nur die Reflexion in Luft bekannt: Für ein anderes Medium folgt daraus keine; Daten mit n und k nehmen.",
    "{material} is linked from another file: make it local first (Object, Relations, Make Local)":
        "{material} ist aus einer anderen Datei verknüpft: erst lokal machen (Objekt, Relationen, Lokal machen)",
    "{material} is no clear body: a common face is between two of them, such as water and glass.":
        "{material} ist kein klarer Körper: eine gemeinsame Fläche liegt zwischen zweien, etwa Wasser und Glas.",
    "{material} is not a material of Facet & Film: make one with create_material() or Bake Spectral Preset.":
        "{material} ist kein Material von Facet & Film: eines mit create_material() oder Spektrale Voreinstellung backen machen.",
    "{material} is not made of what a text says: name a material of another model.":
        "{material} besteht nicht aus dem, was ein Text sagt: ein Material eines anderen Modells nennen.",
    "{model} takes no measurement: name one of its presets, or another model.":
        "{model} nimmt keine Messung: eine seiner Voreinstellungen nennen oder ein anderes Modell.",
    "{name} is written by a bake, as JSON; leave it out, or as it is: not {value!r}.":
        "{name} schreibt ein Backen, als JSON; weglassen oder lassen, wie es ist: nicht {value!r}.",
    "{name} must be a text, not {value!r}.":
        "{name} muss ein Text sein, nicht {value!r}.",
    "{name} {value!r} is no colour: linear numbers go to {most}, and whole ones to 255 are sRGB.":
        "{name} {value!r} ist keine Farbe: Lineare Zahlen gehen bis {most}, ganze bis 255 sind sRGB.",
    "{name} {value!r} is no colour; give three numbers, or one such as '#ffd98b'.":
        "{name} {value!r} ist keine Farbe; drei Zahlen angeben, oder eine wie '#ffd98b'.",
    "{name} {value!r} is unknown; Valid: {valid}.":
        "{name} {value!r} ist unbekannt; gültig: {valid}.",
    "{name} {value!r} is unknown; did you mean {near}? Valid: {valid}.":
        "{name} {value!r} ist unbekannt; war {near} gemeint? Gültig: {valid}.",
    "{preset} has no dataset of the database, so there is nothing to compare: its values are the preset's own. Name another preset, or a dataset such as 'main/Au/Babar'.":
        "{preset} hat keinen Datensatz der Datenbank, es gibt also nichts zu vergleichen: Die Werte sind eigene der Voreinstellung. Bitte eine andere Voreinstellung nennen oder einen Datensatz wie 'main/Au/Babar'.",
    "{preset} is a preset of {model}: leave the model out, or name that one.":
        "{preset} ist eine Voreinstellung von {model}: das Modell weglassen oder jenes nennen.",
    "{preset} was not measured: it is a preset of {model}, which has no spectrum to bake. Make a material of it, or name a measured preset such as 'copper'.":
        "{preset} wurde nicht gemessen: es ist eine Voreinstellung von {model} und hat kein Spektrum zum Backen. Ein Material daraus machen oder eine gemessene Voreinstellung wie 'copper' nennen.",
    "{word!r} is measured from {low:g} to {high:g} nm, so hardly in the visible, 400 to 700 nm; choose "
    "another dataset.":
        "{word!r} ist von {low:g} bis {high:g} nm gemessen, also kaum im Sichtbaren, 400 bis 700 nm; anderen "
        "Datensatz wählen.",
    "{word!r} is outside of the stack and must not absorb, but has k up to {k:.2g}; name something clear, "
    "such as air or water.":
        "{word!r} ist außerhalb des Stapels und darf nicht absorbieren, hat aber k bis {k:.2g}; etwas Klares "
        "nennen, etwa air oder water.",
    "{word!r} is unknown; did you mean {near}? A layer is of a dataset, a preset's material or an index such "
    "as 1.38.":
        "{word!r} ist unbekannt; war {near} gemeint? Eine Schicht ist ein Datensatz, das Material einer "
        "Voreinstellung oder eine Brechzahl wie 1.38.",
}
