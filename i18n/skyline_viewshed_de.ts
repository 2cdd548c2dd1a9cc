<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>SkylineViewshed</name>
    <message>
        <location filename="../plugin.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Photos to viewsheds</source>
        <translation>Fotos zu Sichtfeldern</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Skyline Viewshed: choose photos and an elevation model, and run</source>
        <translation>Skyline Viewshed: Fotos und Höhenmodell wählen und starten</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Begin with the mountain button in the toolbar, or in the Processing toolbox.</source>
        <translation>Beginnen Sie mit der Berg-Schaltfläche in der Werkzeugleiste oder in der Verarbeitungswerkzeugkiste.</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Photo view</source>
        <translation>Fotoansicht</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Look at oriented photographs beside the map, correct and measure.</source>
        <translation>Orientierte Fotos neben der Karte ansehen, korrigieren und ausmessen.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Folder of photographs</source>
        <translation>Ordner mit Fotos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Include subfolders</source>
        <translation>Unterordner einbeziehen</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Elevation model (DEM)</source>
        <translation>Geländemodell (DGM)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Maximum distance (m)</source>
        <translation>Größte Entfernung (m)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Land-cover raster</source>
        <translation>Raster der Landbedeckung</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/orient_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Oriented photos</source>
        <translation>Orientierte Fotos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../panel/view/actions.py"/>
        <source>Viewshed</source>
        <translation>Sichtfeld</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Ground in view</source>
        <translation>Sichtbares Gelände</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Land cover in view</source>
        <translation>Sichtbare Landbedeckung</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Photos to orient again</source>
        <translation>Erneut zu orientierende Fotos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Layer to update</source>
        <translation>Zu aktualisierender Layer</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Field with an approximate heading (°)</source>
        <translation>Feld mit einer ungefähren Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Updated layer</source>
        <translation>Aktualisierter Layer</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Orients some photographs of a layer again, with an approximate heading or landmarks if you give them, updates the layer, and computes anew the ground that its photographs show.</source>
        <translation>Orientiert einige Fotos eines Layers erneut, mit ungefährer Blickrichtung oder Landmarken, falls Sie sie angeben, aktualisiert den Layer und berechnet das Gelände neu, das seine Fotos zeigen.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Reads geotagged JPEG photographs with QGIS's own importer, orients them, and computes the ground they show.</source>
        <translation>Liest JPEG-Fotos mit Koordinaten durch den QGIS-eigenen Import, orientiert sie und berechnet das Gelände, das sie zeigen.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Uses the headings that the cameras recorded, and computes the ground within the horizontal field of view. Phone compasses are often wrong by 5 to 10 degrees or more.</source>
        <translation>Verwendet die Blickrichtungen, die die Kameras aufgezeichnet haben, und berechnet das Gelände innerhalb des horizontalen Bildwinkels. Kompasse von Telefonen liegen oft um 5 bis 10 Grad oder mehr daneben.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Counts the cells of each class of a land-cover raster within the ground that each oriented photograph shows.</source>
        <translation>Zählt die Zellen jeder Klasse eines Rasters der Landbedeckung innerhalb des Geländes, das jedes orientierte Foto zeigt.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>JPEG and HEIC files with a GPS position.</source>
        <translation>JPEG- und HEIC-Dateien mit GPS-Position.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Also searches all subfolders.</source>
        <translation>Durchsucht auch alle Unterordner.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Raster of classes, in any coordinate system.</source>
        <translation>Raster mit Klassen, in einem beliebigen Koordinatensystem.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Points with heading, pitch, roll and field of view.</source>
        <translation>Punkte mit Blickrichtung, Nickwinkel, Rollwinkel und Bildwinkel.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of photographs that show each cell, on the DEM's grid; nodata if it is unknown.</source>
        <translation>Anzahl der Fotos, die jede Zelle zeigen, auf dem Gitter des DGM; NoData, wenn sie unbekannt ist.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>One multipolygon per photograph, with the area seen (m²) and the farthest distance (m).</source>
        <translation>Ein Multipolygon je Foto, mit der gesehenen Fläche (m²) und der größten Entfernung (m).</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Ground in view, with the number of cells of each class in fields class_1, class_2, ...</source>
        <translation>Sichtbares Gelände, mit der Anzahl der Zellen jeder Klasse in den Feldern class_1, class_2, ...</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>The layer of oriented photos; select the photos and tick the box for selected features.</source>
        <translation>Der Layer der orientierten Fotos; wählen Sie die Fotos aus und haken Sie „Nur gewählte Objekte“ an.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>The layer that gets the new answers; usually the same one. It is changed.</source>
        <translation>Der Layer, der die neuen Ergebnisse erhält; meist derselbe. Er wird verändert.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Approximate true heading, clockwise from north. The answer must be near it. NULL: none.</source>
        <translation>Ungefähre geographische Blickrichtung, im Uhrzeigersinn von Nord. Die Antwort muss in ihrer Nähe liegen. NULL: keine.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Points on the map that are visible in photographs, with the fields photo, x and y.</source>
        <translation>Punkte der Karte, die in Fotos zu sehen sind, mit den Feldern photo, x und y.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: geotagged photos to viewsheds</source>
        <translation>Modell: georeferenzierte Fotos zu Sichtfeldern</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: recorded headings to viewsheds</source>
        <translation>Modell: aufgezeichnete Blickrichtungen zu Sichtfeldern</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: orient photos again</source>
        <translation>Modell: Fotos erneut orientieren</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: land cover that photos show</source>
        <translation>Modell: Landbedeckung, die Fotos zeigen</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Photographs</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Terrain and visibility</source>
        <translation>Gelände und Sichtbarkeit</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>All in one</source>
        <translation>Alles in einem</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>From the photo to the map</source>
        <translation>Vom Foto zur Karte</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Checks and simulation</source>
        <translation>Prüfung und Simulation</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Cancelled. Nothing was written.</source>
        <translation>Abgebrochen. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>{name} cannot be kept in memory, as only vector layers can. Choose a temporary file, or name a file or folder.</source>
        <translation>{name} kann nicht im Arbeitsspeicher gehalten werden; das geht nur mit Vektorlayern. Wählen Sie eine temporäre Datei, oder nennen Sie eine Datei oder einen Ordner.</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>{name} cannot be written: {folder} is not a folder you may write to.</source>
        <translation>{name} kann nicht geschrieben werden: In {folder} dürfen Sie nicht schreiben, oder es ist kein Ordner.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Directed viewshed</source>
        <translation>Gerichtetes Sichtfeld</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>viewshed,visibility,photo,field of view,frustum,wedge,dem,sector</source>
        <translation>Sichtfeld,Sichtbarkeit,Sichtbarkeitsanalyse,Foto,Bildwinkel,Sichtpyramide,Sektor,DGM,viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Ground that oriented photographs show: cumulative raster and one polygon per photo</source>
        <translation>Gelände, das orientierte Fotos zeigen: Summenraster und ein Polygon je Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Tests for every cell of the elevation model in range whether it is visible from the camera and lies inside the picture. &lt;i&gt;Photo frame&lt;/i&gt; uses heading, pitch, roll and both fields of view; &lt;i&gt;heading wedge&lt;/i&gt; uses only the heading and the horizontal field of view; &lt;i&gt;full circle&lt;/i&gt; uses none of them.</source>
        <translation>Prüft für jede Zelle des Geländemodells in Reichweite, ob sie von der Kamera aus sichtbar ist und im Bild liegt. &lt;i&gt;Bildausschnitt&lt;/i&gt; verwendet Blickrichtung, Nick- und Rollwinkel und beide Bildwinkel; &lt;i&gt;Blicksektor&lt;/i&gt; verwendet nur die Blickrichtung und den horizontalen Bildwinkel; &lt;i&gt;Vollkreis&lt;/i&gt; verwendet nichts davon.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>The raster uses the DEM's grid and counts the photographs that show each cell; cells for which this is unknown are nodata. The polygons have the area on the ellipsoid (m²) and the farthest distance (m) as attributes. Azimuths count from true north and distances are ground metres, whatever the coordinate system.</source>
        <translation>Das Raster verwendet das Gitter des DGM und zählt die Fotos, die jede Zelle zeigen; Zellen, für die das unbekannt ist, sind NoData. Die Polygone haben die Fläche auf dem Ellipsoid (m²) und die größte Entfernung (m) als Attribute. Azimute zählen ab geographisch Nord und Entfernungen sind Meter am Boden, in jedem Koordinatensystem.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Advanced options: layers with values per cell (distance, elevation angle, how much higher a target must be to be visible, position in the picture), probabilities that account for the errors of pose, position and DEM, and the photographs' own skylines, which exclude ground that the foreground hides. Photographs from exactly the same place are computed together.</source>
        <translation>Erweiterte Optionen: Layer mit Werten je Zelle (Entfernung, Höhenwinkel, wie viel höher ein Ziel sein muss, um sichtbar zu sein, Position im Bild), Wahrscheinlichkeiten, die die Fehler von Ausrichtung, Position und DGM berücksichtigen, und die Horizontlinien der Fotos selbst, die vom Vordergrund verdecktes Gelände ausschließen. Fotos von genau demselben Ort werden gemeinsam berechnet.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>To continue a run that was stopped, repeat it with the same parameters. Finished files in the folders of rasters, layers and probabilities are reused if the DEM, the pose and the settings have not changed.</source>
        <translation>Um einen abgebrochenen Lauf fortzusetzen, wiederholen Sie ihn mit denselben Parametern. Fertige Dateien in den Ordnern der Raster, Layer und Wahrscheinlichkeiten werden wiederverwendet, wenn sich DGM, Ausrichtung und Einstellungen nicht geändert haben.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/panorama.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Oriented photo points</source>
        <translation>Orientierte Fotopunkte</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>From Orient photos, or any points with heading, pitch, roll and field of view.</source>
        <translation>Aus „Fotos orientieren“, oder beliebige Punkte mit Blickrichtung, Nick- und Rollwinkel und Bildwinkel.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the camera's elevation (m)</source>
        <translation>Feld mit der Höhe der Kamera (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Absolute elevation in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Absolute Höhe im Höhensystem des DGM. NULL: DGM plus Kamerahöhe.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Folder for one raster per photo</source>
        <translation>Ordner für ein Raster je Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>GeoTIFFs: 1 seen, 0 not seen, nodata unknown.</source>
        <translation>GeoTIFFs: 1 sichtbar, 0 nicht sichtbar, NoData unbekannt.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of viewsheds</source>
        <translation>Anzahl der Sichtfelder</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>The layer has no heading. Choose the field that holds it, orient the photos first, or take the full circle.</source>
        <translation>Der Layer hat keine Blickrichtung. Wählen Sie das Feld, das sie enthält, orientieren Sie zuerst die Fotos, oder nehmen Sie den Vollkreis.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/export_headings.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the heading (°)</source>
        <translation>Feld mit der Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>True, clockwise from north.</source>
        <translation>Geographisch, im Uhrzeigersinn von Nord.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the horizontal field of view (°)</source>
        <translation>Feld mit dem horizontalen Bildwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Field of view of the upright picture.</source>
        <translation>Bildwinkel des aufrecht stehenden Bildes.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the pitch (°)</source>
        <translation>Feld mit dem Nickwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Up is positive. NULL: wedge, not frame.</source>
        <translation>Nach oben positiv. NULL: Sektor statt Bildausschnitt.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the roll (°)</source>
        <translation>Feld mit dem Rollwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Right side down is positive. NULL: 0.</source>
        <translation>Positiv, wenn die rechte Seite tiefer liegt. NULL: 0.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Field with the vertical field of view (°)</source>
        <translation>Feld mit dem vertikalen Bildwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>NULL: wedge, not frame.</source>
        <translation>NULL: Sektor statt Bildausschnitt.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>End of the 90 % interval, used for probabilities. NULL: a standard deviation of 0.5° is used instead.</source>
        <translation>Ende des 90-%-Intervalls, für Wahrscheinlichkeiten verwendet. NULL: Stattdessen wird eine Standardabweichung von 0,5° verwendet.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Field with the heading's lower end (°)</source>
        <translation>Feld mit dem unteren Ende der Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Field with the heading's upper end (°)</source>
        <translation>Feld mit dem oberen Ende der Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Drape photos over the terrain</source>
        <translation>Fotos über das Gelände legen</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>orthophoto,drape,rectify,texture,mosaic,photo,rgba,ground sampling distance</source>
        <translation>Orthofoto,drapieren,entzerren,Textur,Mosaik,Foto,RGBA,Bodenauflösung</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Colour raster on the DEM's grid: each cell as the photo shows it, transparent where hidden</source>
        <translation>Farbraster auf dem Gitter des DGM: jede Zelle, wie das Foto sie zeigt, durchsichtig, wo sie verdeckt ist</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Each cell that a photograph shows gets the colour of the pixels that show it; all other cells are transparent. If several photographs show a cell, their colours are blended: the photograph with the finest resolution there has the greatest weight, and each photograph fades out towards its edges.</source>
        <translation>Jede Zelle, die ein Foto zeigt, erhält die Farbe der Pixel, die sie zeigen; alle anderen Zellen sind transparent. Zeigen mehrere Fotos eine Zelle, werden ihre Farben überblendet: Das Foto mit der dort feinsten Auflösung hat das größte Gewicht, und jedes Foto läuft zu seinen Rändern hin aus.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Sky is not draped: a cell whose pixel lies above the skyline of the picture stays transparent.</source>
        <translation>Himmel wird nicht drapiert: Eine Zelle, deren Pixel über der Horizontlinie des Bildes liegt, bleibt durchsichtig.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>The second raster gives the ground sampling distance of the best photo in metres per pixel: band 1 across the line of sight, band 2 along it on the slope, which is long if the line of sight grazes the ground. Trees and people in the picture are draped too, because the DEM does not contain them.</source>
        <translation>Das zweite Raster gibt die Bodenauflösung des besten Fotos in Metern je Pixel: Kanal 1 quer zur Sichtlinie, Kanal 2 längs auf dem Hang; dieser Wert ist groß, wenn die Sichtlinie das Gelände streift. Auch Bäume und Menschen im Bild werden auf das Gelände gelegt, weil das DGM sie nicht enthält.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Cells per side of a DEM cell</source>
        <translation>Zellen je Seite einer DGM-Zelle</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>1: the DEM's own grid. 4: sixteen times as many cells, for a photo finer than the DEM.</source>
        <translation>1: das Gitter des DGM. 4: sechzehnmal so viele Zellen, für ein Foto, das feiner ist als das DGM.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Minimum distance (m)</source>
        <translation>Mindestentfernung (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Ground nearer than this is left out.</source>
        <translation>Näheres Gelände bleibt weg.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Draped photos</source>
        <translation>Auf das Gelände gelegte Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>GeoTIFF of red, green, blue and opacity; transparent where no photo sees the cell.</source>
        <translation>GeoTIFF mit Rot, Grün, Blau und Deckkraft; durchsichtig, wo kein Foto die Zelle sieht.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Ground sampling distance</source>
        <translation>Bodenauflösung</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Metres per pixel of the best photo: band 1 across the view, band 2 along it.</source>
        <translation>Meter je Pixel des besten Fotos: Band 1 quer zum Blick, Band 2 längs.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Number of photos draped</source>
        <translation>Anzahl der aufgelegten Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Number of cells with colour</source>
        <translation>Anzahl der Zellen mit Farbe</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>The point names no photo.</source>
        <translation>Der Punkt nennt kein Foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>{share} % of the ground in view lies where the picture shows sky, and was not draped. Check the heading, the pitch and the elevation of the camera.</source>
        <translation>{share} % des sichtbaren Geländes liegen dort, wo das Bild Himmel zeigt, und wurden nicht drapiert. Prüfen Sie Blickrichtung, Nickwinkel und Höhe der Kamera.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Expected accuracy</source>
        <translation>Erwartete Genauigkeit</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>simulation,accuracy,benchmark,planning,acceptance,coverage,montecarlo</source>
        <translation>Simulation,Genauigkeit,Benchmark,Planung,Annahme,Abdeckung,Montecarlo</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>How accurate orientation will be at given places over a given DEM, from simulated photographs</source>
        <translation>Wie genau die Orientierung an gegebenen Orten über einem gegebenen DGM sein wird, aus simulierten Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Simulates photographs from the places with random directions, lenses, weather and errors of position and focal length, orients each of them as Orient photos does, and compares the answers with the truth: errors, share of accepted photographs, wrong ones among them, and how often the 90 % interval holds the truth.</source>
        <translation>Simuliert Fotos von den Orten mit zufälligen Richtungen, Objektiven, Wetterlagen und Fehlern von Position und Brennweite, orientiert jedes wie „Fotos orientieren“ und vergleicht die Antworten mit der Wahrheit: Fehler, Anteil der angenommenen Fotos, falsche darunter und wie oft das 90-%-Intervall die Wahrheit enthält.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The simulated mountains are rougher than the DEM. Each photograph takes some seconds. Real photographs can give worse results: compare with the figures for real photographs in the documentation.</source>
        <translation>Die simulierten Berge sind rauer als das DGM. Jedes Foto dauert einige Sekunden. Echte Fotos können schlechtere Ergebnisse liefern: Vergleichen Sie mit den Zahlen für echte Fotos in der Dokumentation.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Points, or lines along which places are taken.</source>
        <translation>Punkte oder Linien, entlang derer Orte genommen werden.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Distance between the places that are taken along lines.</source>
        <translation>Abstand der Orte, die entlang von Linien genommen werden.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Step along lines (m)</source>
        <translation>Schritt entlang von Linien (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>They are spread evenly over the places.</source>
        <translation>Sie werden gleichmäßig auf die Orte verteilt.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Number of photographs</source>
        <translation>Anzahl der Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Weather</source>
        <translation>Wetter</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>clear days</source>
        <translation>klare Tage</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>half clear, half a season's weather</source>
        <translation>halb klar, halb Wetter einer Saison</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>a season's weather</source>
        <translation>Wetter einer Saison</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>A season's weather has clouds, haze, trees, people and camera faults.</source>
        <translation>Das Wetter einer Saison hat Wolken, Dunst, Bäume, Menschen und Kamerafehler.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Fields of view are drawn between the two.</source>
        <translation>Die Bildwinkel werden zwischen den beiden gezogen.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Narrowest field of view (°)</source>
        <translation>Kleinster Bildwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Widest field of view (°)</source>
        <translation>Größter Bildwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Standard deviation of the recorded position in each direction.</source>
        <translation>Standardabweichung der aufgezeichneten Position in jeder Richtung.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Error of the position (m)</source>
        <translation>Fehler der Position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Roughness of the mountains that the DEM does not show, in cells of the DEM. 0: the photographs show the DEM itself.</source>
        <translation>Rauheit der Berge, die das DGM nicht zeigt, in Zellen des DGM. 0: Die Fotos zeigen das DGM selbst.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Roughness beyond the DEM</source>
        <translation>Rauheit über das DGM hinaus</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The same seed gives the same photographs.</source>
        <translation>Derselbe Startwert ergibt dieselben Fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>One point per simulated photograph with its truth, the answer and the error.</source>
        <translation>Ein Punkt je simuliertem Foto mit Wahrheit, Antwort und Fehler.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Simulated photographs</source>
        <translation>Simulierte Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/export_headings.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/orient_photos.py"/>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Number of photos</source>
        <translation>Anzahl der Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/orient_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of accepted photos</source>
        <translation>Anzahl der angenommenen Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Accepted photos that are wrong by more than 3°</source>
        <translation>Angenommene Fotos, die um mehr als 3° falsch sind</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of headings within 1°</source>
        <translation>Anteil der Blickrichtungen innerhalb von 1°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of headings within 3°</source>
        <translation>Anteil der Blickrichtungen innerhalb von 3°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of the accepted whose interval holds the truth</source>
        <translation>Anteil der angenommenen, deren Intervall die Wahrheit enthält</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The narrowest field of view must not be wider than the widest.</source>
        <translation>Der kleinste Bildwinkel darf nicht größer sein als der größte.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>None of the places has a usable position on this DEM.</source>
        <translation>Keiner der Orte hat eine brauchbare Position auf diesem DGM.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/panorama.py"/>
        <location filename="../algorithms/shared/viewer.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../panel/model/session.py"/>
        <source>The point has no usable position.</source>
        <translation>Der Punkt hat keine brauchbare Position.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>{photos} photographs: {accepted} accepted, {wrong} of them wrong by more than 3°; {within} % of all headings are within 1° of the truth.</source>
        <translation>{photos} Fotos: {accepted} angenommen, davon {wrong} um mehr als 3° falsch; {within} % aller Blickrichtungen liegen innerhalb von 1° der Wahrheit.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>True heading (°)</source>
        <translation>Wahre Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Heading found minus true heading (°)</source>
        <translation>Gefundene minus wahre Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Probability of a unique answer, predicted from the DEM</source>
        <translation>Wahrscheinlichkeit einer eindeutigen Antwort, aus dem DGM vorhergesagt</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view (°)</source>
        <translation>Horizontaler Bildwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Heading (° from true north)</source>
        <translation>Blickrichtung (° von geographisch Nord)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The 90 % interval holds the true heading</source>
        <translation>Das 90-%-Intervall enthält die wahre Blickrichtung</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Probability that the heading is right within 3°</source>
        <translation>Wahrscheinlichkeit, dass die Blickrichtung auf 3° stimmt</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Export headings</source>
        <translation>Blickrichtungen exportieren</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>photo,heading,export,xmp,sidecar,kml,kmz,photooverlay,csv,google earth,lightroom,digikam</source>
        <translation>Foto,Blickrichtung,Export,XMP,Sidecar,KML,KMZ,PhotoOverlay,CSV,Google Earth,Lightroom,digiKam</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Headings as XMP sidecars, KML or KMZ with the pictures, and a CSV table</source>
        <translation>Blickrichtungen als XMP-Begleitdateien, KML oder KMZ mit den Bildern und CSV-Tabelle</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Writes the headings of oriented photographs for other programs. The photographs themselves are never changed.</source>
        <translation>Schreibt die Blickrichtungen orientierter Fotos für andere Programme. Die Fotos selbst werden nie verändert.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>&lt;b&gt;Sidecars&lt;/b&gt; are named IMG_1.jpg.xmp, as digiKam, darktable and ExifTool read them, with GPSImgDirection against true north. The folders below the photographs' common folder are kept, so choose that common folder to have each sidecar beside its photograph. Sidecars of other programs are left alone. &lt;b&gt;KMZ&lt;/b&gt; contains reduced pictures; &lt;b&gt;KML&lt;/b&gt; points to the originals. Google Earth shows each picture in its place.</source>
        <translation>&lt;b&gt;Begleitdateien&lt;/b&gt; heißen IMG_1.jpg.xmp, wie digiKam, darktable und ExifTool sie lesen, mit GPSImgDirection gegen geographisch Nord. Die Ordner unterhalb des gemeinsamen Ordners der Fotos bleiben erhalten; wählen Sie also diesen gemeinsamen Ordner, damit jede Begleitdatei neben ihrem Foto liegt. Begleitdateien anderer Programme bleiben unberührt. &lt;b&gt;KMZ&lt;/b&gt; enthält verkleinerte Bilder; &lt;b&gt;KML&lt;/b&gt; verweist auf die Originale. Google Earth zeigt jedes Bild an seinem Ort.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Only photographs with the status &lt;i&gt;accepted&lt;/i&gt; or &lt;i&gt;confirmed&lt;/i&gt;, or without a status, are exported, unless you request the doubtful ones too.</source>
        <translation>Nur Fotos mit dem Status &lt;i&gt;accepted&lt;/i&gt; oder &lt;i&gt;confirmed&lt;/i&gt; oder ohne Status werden exportiert, es sei denn, Sie verlangen auch die zweifelhaften.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Clockwise from true north.</source>
        <translation>Im Uhrzeigersinn von geographisch Nord.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Doubtful photos too</source>
        <translation>Auch zweifelhafte Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Exports photos whose heading is not reliable as well.</source>
        <translation>Exportiert auch Fotos, deren Blickrichtung nicht verlässlich ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>One XMP file per photo. Choose the photos' common folder to have each beside its photo.</source>
        <translation>Eine XMP-Datei pro Foto. Wählen Sie den gemeinsamen Ordner der Fotos, damit jede neben ihrem Foto liegt.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Folder for XMP sidecars</source>
        <translation>Ordner für XMP-Begleitdateien</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>KML or KMZ</source>
        <translation>KML oder KMZ</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>KMZ files (*.kmz);;KML files (*.kml)</source>
        <translation>KMZ-Dateien (*.kmz);;KML-Dateien (*.kml)</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>For Google Earth; a KMZ file contains the pictures.</source>
        <translation>Für Google Earth; eine KMZ-Datei enthält die Bilder.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>One line per photo, for spreadsheets.</source>
        <translation>Eine Zeile pro Foto, für Tabellenprogramme.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Number of photos left out</source>
        <translation>Anzahl ausgelassener Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Choose at least one output: the folder for sidecars, the KML file or the table.</source>
        <translation>Wählen Sie mindestens eine Ausgabe: den Ordner für Begleitdateien, die KML-Datei oder die Tabelle.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>No photo of the layer has a heading that can be exported. Orient the photos first.</source>
        <translation>Kein Foto des Layers hat eine Blickrichtung, die sich exportieren lässt. Orientieren Sie die Fotos zuerst.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>{count} headings exported.</source>
        <translation>{count} Blickrichtungen exportiert.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../panel/model/session.py"/>
        <location filename="../core/many.py"/>
        <source>The point names no photo. Fill its path field.</source>
        <translation>Der Punkt nennt kein Foto. Füllen Sie sein Pfadfeld aus.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out, because it has no heading.</source>
        <translation>ausgelassen, weil keine Blickrichtung bekannt ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out, because its status is {status}.</source>
        <translation>ausgelassen, weil der Status {status} ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out of the KML file, because its point has no position.</source>
        <translation>nicht in der KML-Datei, weil der Punkt keine Position hat.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left as it is, because another program wrote {path}.</source>
        <translation>unverändert, weil ein anderes Programm {path} geschrieben hat.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Extract skyline</source>
        <translation>Horizontlinie ausziehen</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>photo,skyline,horizon,sky,segmentation,ridge,overlay</source>
        <translation>Foto,Horizontlinie,Horizont,Himmel,Segmentierung,Grat,Überlagerung,skyline</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Boundary between sky and terrain in photographs, with a confidence per column</source>
        <translation>Grenze zwischen Himmel und Gelände in Fotos, mit einer Zuverlässigkeit je Spalte</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Writes one row per picture column. &lt;b&gt;column&lt;/b&gt; and &lt;b&gt;row&lt;/b&gt; are pixels of the full upright picture (the first pixel is 0; row is the first terrain pixel). &lt;b&gt;confidence&lt;/b&gt; ranges from 0 (no plausible boundary, interpolated) to 1.</source>
        <translation>Schreibt eine Zeile je Bildspalte. &lt;b&gt;column&lt;/b&gt; und &lt;b&gt;row&lt;/b&gt; sind Pixel des vollen, aufrecht stehenden Bildes (das erste Pixel ist 0; row ist das erste Geländepixel). &lt;b&gt;confidence&lt;/b&gt; reicht von 0 (keine plausible Grenze, interpoliert) bis 1.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>If the automatic skyline is wrong, correct the table by hand and use it in &lt;i&gt;Orient photos&lt;/i&gt; as &lt;i&gt;Drawn skylines&lt;/i&gt;. The overlays are PNG pictures for checking the skyline.</source>
        <translation>Wenn die automatische Horizontlinie falsch ist, berichtigen Sie die Tabelle von Hand und verwenden Sie sie in &lt;i&gt;Fotos orientieren&lt;/i&gt; als &lt;i&gt;Gezeichnete Horizontlinien&lt;/i&gt;. Die Überlagerungen sind PNG-Bilder zum Prüfen der Horizontlinie.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Robust: finds the most likely line as a whole, even with haze, clouds and noise. Paper: uses the published filters, column by column.</source>
        <translation>Robust: findet die im Ganzen wahrscheinlichste Linie, auch bei Dunst, Wolken und Rauschen. Aufsatz: verwendet die veröffentlichten Filter, Spalte für Spalte.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Skylines</source>
        <translation>Horizontlinien</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>One row per picture column: photo, column and row (px of the upright picture), confidence (0 to 1).</source>
        <translation>Eine Zeile je Bildspalte: Foto, Spalte und Zeile (px des aufrechten Bildes), Vertrauen (0 bis 1).</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Folder of overlays</source>
        <translation>Ordner für Überlagerungen</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>One PNG per photograph with its skyline.</source>
        <translation>Ein PNG je Foto mit seiner Horizontlinie.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Number of skylines</source>
        <translation>Anzahl der Horizontlinien</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/measure_offsets.py"/>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/shared/fields.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <location filename="../core/base/attributes.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Column (px, from the left)</source>
        <translation>Spalte (px, von links)</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Row (px, from the top)</source>
        <translation>Zeile (px, von oben)</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Confidence (0 to 1)</source>
        <translation>Zuverlässigkeit (0 bis 1)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Horizon profile</source>
        <translation>Horizontprofil</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>horizon,skyline,panorama,sky view factor,shading,elevation angle,dem</source>
        <translation>Horizont,Horizontlinie,Panorama,Himmelssichtfaktor,Abschattung,Höhenwinkel,DGM</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Elevation angle and distance of the horizon around points, and their sky view factor</source>
        <translation>Höhenwinkel und Entfernung des Horizonts rund um Punkte und ihr Himmelssichtfaktor</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Computes the elevation angle, the distance and the position of the horizon for each point and azimuth. Azimuths count from true north and distances are ground metres in any coordinate system of the DEM. The earth's curvature and refraction are taken into account.</source>
        <translation>Berechnet für jeden Punkt und jedes Azimut den Höhenwinkel, die Entfernung und die Position des Horizonts. Azimute zählen ab geographisch Nord und Entfernungen sind Meter am Boden in jedem Koordinatensystem des DGM. Erdkrümmung und Refraktion sind berücksichtigt.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>&lt;b&gt;clipped&lt;/b&gt; is true if the elevation model ends before the search range and there could be higher terrain beyond it. &lt;b&gt;svf&lt;/b&gt; is the sky view factor of the source point (1 = open sky).</source>
        <translation>&lt;b&gt;clipped&lt;/b&gt; ist wahr, wenn das Geländemodell vor der Suchweite endet und dahinter höheres Gelände liegen könnte. &lt;b&gt;svf&lt;/b&gt; ist der Himmelssichtfaktor des Ausgangspunkts (1 = freier Himmel).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Under Advanced you can add a raster with the sky view factor of each cell in an extent, which takes the cell's own slope into account (Dozier and Frew 1990).</source>
        <translation>Unter Erweitert können Sie ein Raster mit dem Himmelssichtfaktor jeder Zelle einer Ausdehnung hinzufügen, das die eigene Hangneigung der Zelle berücksichtigt (Dozier und Frew 1990).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Positions of the observer's eye, in any coordinate system.</source>
        <translation>Positionen des Beobachterauges, in jedem Koordinatensystem.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth step (°)</source>
        <translation>Azimutschritt (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Spacing of the directions; it is rounded so that it divides the circle.</source>
        <translation>Abstand der Richtungen; er wird so gerundet, dass er den Kreis teilt.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../core/figures/profile.py"/>
        <source>Horizon</source>
        <translation>Horizont</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>One point per azimuth at the position of the horizon, with elevation angle (°) and distance (m).</source>
        <translation>Ein Punkt je Azimut an der Position des Horizonts, mit Höhenwinkel (°) und Entfernung (m).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Number of points with a horizon</source>
        <translation>Anzahl der Punkte mit Horizont</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Source point</source>
        <translation>Ausgangspunkt</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Azimuth (° from true north)</source>
        <translation>Azimut (° von geographisch Nord)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Elevation angle of the horizon (°)</source>
        <translation>Höhenwinkel des Horizonts (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Distance of the horizon (m)</source>
        <translation>Entfernung des Horizonts (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Cut off by the DEM's edge</source>
        <translation>Am Rand des DGM abgeschnitten</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Sky view factor of the source point</source>
        <translation>Himmelssichtfaktor des Ausgangspunkts</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Import mountain photos</source>
        <translation>Bergfotos importieren</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>photo,exif,heic,jpeg,geotag,gps,import,focal length,compass</source>
        <translation>Foto,EXIF,HEIC,JPEG,Geotag,GPS,Import,Brennweite,Kompass</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Point layer of the photographs in a folder, with field of view and compass reference</source>
        <translation>Punktlayer der Fotos eines Ordners, mit Bildwinkel und Kompassbezug</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Makes one point per photograph with a position. It writes the same fields as QGIS's &lt;i&gt;Import geotagged photos&lt;/i&gt; and adds what orientation needs: 35 mm equivalent, field of view, size of the upright picture, reference of the compass (true or magnetic), GPS error, camera.</source>
        <translation>Erzeugt einen Punkt je Foto mit Position. Es schreibt dieselben Felder wie &lt;i&gt;Geotaggte Fotos importieren&lt;/i&gt; von QGIS und ergänzt, was die Orientierung braucht: kleinbildäquivalente Brennweite, Bildwinkel, Größe des aufrecht stehenden Bildes, Kompassbezug (geographisch oder magnetisch), GPS-Fehler, Kamera.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Values that a file does not contain are NULL. The optional table of rejected photographs lists photographs without a usable position and files that cannot be read, with the reason.</source>
        <translation>Werte, die eine Datei nicht enthält, sind NULL. Die optionale Tabelle der abgewiesenen Fotos nennt Fotos ohne brauchbare Position und unlesbare Dateien, jeweils mit dem Grund.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>JPEG and HEIC files, and PNG, TIFF and WebP files that record a position.</source>
        <translation>JPEG- und HEIC-Dateien sowie PNG-, TIFF- und WebP-Dateien, die eine Position enthalten.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>One point per photograph at the recorded position, with the recorded altitude as Z.</source>
        <translation>Ein Punkt je Foto an der aufgezeichneten Position, mit der aufgezeichneten Höhe als Z.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Rejected photos</source>
        <translation>Abgewiesene Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Table of the files that produced no point, with the reason.</source>
        <translation>Tabelle der Dateien, die keinen Punkt ergeben haben, mit dem Grund.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Number of rejected photos</source>
        <translation>Anzahl der abgewiesenen Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>The photo has no GPS position.</source>
        <translation>Das Foto hat keine GPS-Position.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Label peaks in photos</source>
        <translation>Gipfel in Fotos beschriften</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>peak,summit,mountain,name,label,annotate,prominence,openstreetmap,geonames</source>
        <translation>Gipfel,Berg,Name,Beschriftung,Schartenhöhe,Prominenz,OpenStreetMap,GeoNames</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summits in the picture with visibility, distance and position; annotated PNG and SVG</source>
        <translation>Gipfel im Bild mit Sichtbarkeit, Entfernung und Position; beschriftete PNG und SVG</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Uses a point layer with names and heights (OpenStreetMap &lt;i&gt;natural=peak&lt;/i&gt;, GeoNames), or finds summits in the elevation model by their prominence. Each published summit is moved to the nearby top in the DEM, because published positions and coarse DEMs differ by hundreds of metres. Then its visibility in the photo is tested.</source>
        <translation>Verwendet einen Punktlayer mit Namen und Höhen (OpenStreetMap &lt;i&gt;natural=peak&lt;/i&gt;, GeoNames) oder sucht Gipfel im Geländemodell nach ihrer Schartenhöhe. Jeder veröffentlichte Gipfel wird auf die nahe Kuppe im DGM verschoben, weil veröffentlichte Positionen und grobe DGM um Hunderte Meter voneinander abweichen. Danach wird geprüft, ob er im Foto sichtbar ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Labels never overlap. The more important summit (by prominence, otherwise by height above the others in view) gets the better place. Labels without room are left out of the picture; the layer contains all summits.</source>
        <translation>Beschriftungen überlappen nie. Der wichtigere Gipfel (nach Schartenhöhe, sonst nach der Höhe über den übrigen sichtbaren) erhält den besseren Platz. Beschriftungen ohne Platz fehlen im Bild; der Layer enthält alle Gipfel.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summits in photos</source>
        <translation>Gipfel in Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>One point for each photo and each summit in its frame, with name, distance (m) and position in the picture (px).</source>
        <translation>Ein Punkt für jedes Foto und jeden Gipfel in dessen Bildausschnitt, mit Name, Entfernung (m) und Position im Bild (px).</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>One PNG and one SVG per photo with the names written in.</source>
        <translation>Ein PNG und ein SVG je Foto mit eingeschriebenen Namen.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Folder for labelled photos</source>
        <translation>Ordner für beschriftete Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Number of summits in frame</source>
        <translation>Anzahl der Gipfel im Bildausschnitt</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Number of visible summits</source>
        <translation>Anzahl der sichtbaren Gipfel</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summit</source>
        <translation>Gipfel</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Published height, otherwise height in the DEM (m)</source>
        <translation>Veröffentlichte Höhe, sonst Höhe im DGM (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Height of the DEM's top (m)</source>
        <translation>Höhe der Kuppe im DGM (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Moved to the DEM's top by (m)</source>
        <translation>Verschoben auf die Kuppe des DGM um (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Prominence in the DEM (m), if summits were searched</source>
        <translation>Schartenhöhe im DGM (m), wenn Gipfel gesucht wurden</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>visible, hidden, unknown</source>
        <translation>visible (sichtbar), hidden (verdeckt), unknown (unbekannt)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Column (px)</source>
        <translation>Spalte (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Row (px)</source>
        <translation>Zeile (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Distance (m)</source>
        <translation>Entfernung (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Elevation angle (°)</source>
        <translation>Höhenwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Locate photos</source>
        <translation>Fotos lokalisieren</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>position,place,where,geolocation,photo,skyline,horizon,archive,search,gps,geotag</source>
        <translation>Position,Ort,wo,Geolokalisierung,Foto,Horizontlinie,Horizont,Archiv,Suche,GPS,Geotag</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Where photographs were taken, from their skyline and a DEM alone</source>
        <translation>Wo Fotos aufgenommen wurden, allein aus ihrer Horizontlinie und einem DGM</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Compares the skyline of each photograph with the horizons of all places of an area, and gives the place, heading, pitch and roll that fit best. No position is needed in the photographs.</source>
        <translation>Vergleicht die Horizontlinie jedes Fotos mit den Horizonten aller Orte eines Gebiets und gibt Ort, Blickrichtung, Nick- und Rollwinkel an, die am besten passen. Die Fotos brauchen keine Position.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>&lt;b&gt;status&lt;/b&gt; is &lt;i&gt;accepted&lt;/i&gt; (the place can be trusted), &lt;i&gt;ambiguous&lt;/i&gt; (compare the candidates), &lt;i&gt;rejected&lt;/i&gt; (the photograph was probably not taken in this area, or its skyline does not decide) or &lt;i&gt;failed&lt;/i&gt;. &lt;b&gt;p_correct&lt;/b&gt; is the probability that the place is within 500 m and the heading within 3 degrees of the truth.</source>
        <translation>&lt;b&gt;status&lt;/b&gt; ist &lt;i&gt;accepted&lt;/i&gt; (dem Ort kann man trauen), &lt;i&gt;ambiguous&lt;/i&gt; (vergleichen Sie die Kandidaten), &lt;i&gt;rejected&lt;/i&gt; (das Foto wurde wahrscheinlich nicht in diesem Gebiet aufgenommen, oder seine Horizontlinie entscheidet nicht) oder &lt;i&gt;failed&lt;/i&gt;. &lt;b&gt;p_correct&lt;/b&gt; ist die Wahrscheinlichkeit, dass der Ort auf 500 m und die Blickrichtung auf 3 Grad richtig sind.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>The horizons of the area are computed once, about 2 ms for each place. Choose a folder for them to use them again. A wide view of far mountains can be located well; a telephoto view or a near slope cannot. A place can reveal where people live or were: use the answer responsibly.</source>
        <translation>Die Horizonte des Gebiets werden einmal berechnet, etwa 2 ms je Ort. Wählen Sie einen Ordner für sie, um sie wieder zu verwenden. Ein weiter Blick auf ferne Berge lässt sich gut lokalisieren, eine Teleaufnahme oder ein naher Hang nicht. Ein Ort kann verraten, wo Menschen leben oder waren: Gehen Sie verantwortungsvoll mit der Antwort um.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>One point per photograph, in place of a folder. Its position is the centre of a search in a radius; otherwise it is only compared with the answer.</source>
        <translation>Ein Punkt je Foto, anstelle eines Ordners. Seine Position ist die Mitte einer Suche in einem Umkreis; sonst wird sie nur mit der Antwort verglichen.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Best places</source>
        <translation>Beste Orte</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>One point per photograph at the best place.</source>
        <translation>Ein Punkt je Foto am besten Ort.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Candidate places</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>The best places of each photograph, ranked, with the pose at each.</source>
        <translation>Die besten Orte jedes Fotos der Reihe nach, mit der Kamerahaltung an jedem.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Regions of 90 % probability</source>
        <translation>Gebiete von 90 % Wahrscheinlichkeit</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Polygons that hold 90 % of the probability if the photograph was taken in the area.</source>
        <translation>Polygone, die 90 % der Wahrscheinlichkeit enthalten, wenn das Foto in dem Gebiet aufgenommen wurde.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Distance between the places that are tried; the best of them are moved afterwards.</source>
        <translation>Abstand der Orte, die probiert werden; die besten von ihnen werden danach verschoben.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Spacing of the places (m)</source>
        <translation>Abstand der Orte (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <source>Field of view of the upright picture. NULL: computed from the focal length in the file.</source>
        <translation>Bildwinkel des aufrechten Bildes. NULL: aus der Brennweite in der Datei berechnet.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Tried for photographs without a focal length and without a given field of view.</source>
        <translation>Wird für Fotos ohne Brennweite und ohne gegebenen Bildwinkel probiert.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Narrowest field of view to try (°)</source>
        <translation>Kleinster Bildwinkel, der probiert wird (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Widest field of view to try (°)</source>
        <translation>Größter Bildwinkel, der probiert wird (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Greatest height of the camera above the ground, for towers and drones. Heights up to it are tried.</source>
        <translation>Größte Höhe der Kamera über dem Boden, für Türme und Drohnen. Höhen bis dahin werden probiert.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Greatest camera height (m)</source>
        <translation>Größte Kamerahöhe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <source>Maximum distance of the mountains on the skyline, in metres on the ground.</source>
        <translation>Größte Entfernung der Berge auf der Horizontlinie, in Metern am Boden.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Largest index of horizons that is held in memory; a folder for the index has no such limit.</source>
        <translation>Größter Index von Horizonten, der im Speicher gehalten wird; ein Ordner für den Index hat keine solche Grenze.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Memory for the index (MB)</source>
        <translation>Speicher für den Index (MB)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Keeps the horizons of the area, about 3 kB for each place, so that later runs start at once.</source>
        <translation>Bewahrt die Horizonte des Gebiets auf, etwa 3 kB je Ort, damit spätere Läufe sofort beginnen.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Folder for the index</source>
        <translation>Ordner für den Index</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>A point without a photo</source>
        <translation>Ein Punkt ohne Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../core/many.py"/>
        <source>An unexpected error occurred on this photo. Please report it and attach the log.</source>
        <translation>Bei diesem Foto ist ein unerwarteter Fehler aufgetreten. Bitte melden Sie ihn und fügen Sie das Protokoll bei.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>{count} places are searched.</source>
        <translation>{count} Orte werden durchsucht.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Map to pixels</source>
        <translation>Karte zu Pixeln</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>project,overlay,photo,pixel,visible,hidden,trail,outline,annotate,augmented</source>
        <translation>projizieren,Überlagerung,Foto,Pixel,sichtbar,verdeckt,Weg,Umriss,beschriften,Augmented Reality</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Where points, lines and areas of the map appear in oriented photos, and what hides them</source>
        <translation>Wo Punkte, Linien und Flächen der Karte in orientierten Fotos erscheinen, und was sie verdeckt</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Converts points, lines (such as a trail) and areas (such as a glacier's outline of 1900) to image coordinates. Lines and outlines follow the terrain and are cut where they disappear behind it or leave the picture. The state of each piece is &lt;b&gt;visible&lt;/b&gt;, &lt;b&gt;hidden&lt;/b&gt;, &lt;b&gt;outside&lt;/b&gt; or &lt;b&gt;unknown&lt;/b&gt; (no elevation there). For areas, the visible share is given as well.</source>
        <translation>Rechnet Punkte, Linien (etwa einen Weg) und Flächen (etwa den Umriss eines Gletschers von 1900) in Bildkoordinaten um. Linien und Umrisse folgen dem Gelände und werden zerschnitten, wo sie dahinter verschwinden oder das Bild verlassen. Der Zustand jedes Stücks ist &lt;b&gt;visible&lt;/b&gt; (sichtbar), &lt;b&gt;hidden&lt;/b&gt; (verdeckt), &lt;b&gt;outside&lt;/b&gt; (außerhalb) oder &lt;b&gt;unknown&lt;/b&gt; (dort keine Höhe). Für Flächen wird auch der sichtbare Anteil angegeben.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>A point with a height is a summit if the ground at its place is lower. It is then moved to the nearby top in the DEM, as in &lt;i&gt;Label peaks in photos&lt;/i&gt;: published positions and coarse DEMs differ by hundreds of metres.</source>
        <translation>Ein Punkt mit einer Höhe ist ein Gipfel, wenn das Gelände an seiner Stelle niedriger ist. Er wird dann wie in &lt;i&gt;Gipfel in Fotos beschriften&lt;/i&gt; auf den nahen höchsten Punkt im Höhenmodell versetzt: Veröffentlichte Lagen und grobe Höhenmodelle weichen um Hunderte von Metern voneinander ab.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>The output has the coordinates of the picture as QGIS shows it without georeference: x to the right, y negative downwards from the upper left corner. Load it together with the photo. The fields &lt;b&gt;x_px&lt;/b&gt; and &lt;b&gt;y_px&lt;/b&gt; count from the centre of the first pixel, with y downwards.</source>
        <translation>Die Ausgabe hat die Koordinaten des Bildes, wie QGIS es ohne Georeferenz zeigt: x nach rechts, y negativ nach unten von der oberen linken Ecke. Laden Sie sie zusammen mit dem Foto. Die Felder &lt;b&gt;x_px&lt;/b&gt; und &lt;b&gt;y_px&lt;/b&gt; zählen von der Mitte des ersten Pixels, y nach unten.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Map features</source>
        <translation>Kartenobjekte</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points, lines or areas in any coordinate system. Heights are taken from the DEM; Z values are ignored.</source>
        <translation>Punkte, Linien oder Flächen in jedem Koordinatensystem. Höhen kommen aus dem DGM; Z-Werte werden ignoriert.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/shared/summit_input.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Field with names</source>
        <translation>Feld mit Namen</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Written to the output and into the pictures.</source>
        <translation>Wird in die Ausgabe und in die Bilder geschrieben.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Points with a height that their ground does not reach are summits. NULL: the point lies on the ground.</source>
        <translation>Punkte mit einer Höhe, die ihr Gelände nicht erreicht, sind Gipfel. NULL: Der Punkt liegt auf dem Gelände.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Height above ground (m)</source>
        <translation>Höhe über Grund (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Height of points above the ground. Lines and areas lie on the ground.</source>
        <translation>Höhe der Punkte über dem Boden. Linien und Flächen liegen auf dem Boden.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Step along lines (px)</source>
        <translation>Schrittweite entlang von Linien (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines are followed in steps of this length.</source>
        <translation>Linien werden in Schritten dieser Länge verfolgt.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points in pictures</source>
        <translation>Punkte in Bildern</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points in pixels of the photo as QGIS shows it (not rotated), with negative y for rows; x_px and y_px count on the upright picture. The field state tells whether the photo shows them.</source>
        <translation>Punkte in Pixeln des Fotos, wie QGIS es zeigt (nicht gedreht), mit negativem y für Zeilen; x_px und y_px zählen im aufrechten Bild. Das Feld state sagt, ob das Foto sie zeigt.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines and outlines in pictures</source>
        <translation>Linien und Umrisse in Bildern</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines and outlines in pixels of the photo as QGIS shows it (not rotated), with negative y for rows, cut where their visibility changes.</source>
        <translation>Linien und Umrisse in Pixeln des Fotos, wie QGIS es zeigt (nicht gedreht), mit negativem y für Zeilen, geteilt, wo sich ihre Sichtbarkeit ändert.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>One PNG and one SVG per photo with the features drawn in; hidden parts are dashed.</source>
        <translation>Ein PNG und ein SVG je Foto mit eingezeichneten Objekten; verdeckte Teile sind gestrichelt.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Folder for annotated photos</source>
        <translation>Ordner für Fotos mit Einzeichnung</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Number of points and pieces</source>
        <translation>Anzahl der Punkte und Stücke</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Number of visible points and pieces</source>
        <translation>Anzahl der sichtbaren Punkte und Stücke</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines in pictures</source>
        <translation>Linien in Bildern</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Measure angular offsets</source>
        <translation>Winkelabweichungen messen</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>accuracy,landmark,offset,skyline,evaluation,table</source>
        <translation>Genauigkeit,Landmarke,Abweichung,Horizontlinie,Bewertung,Tabelle</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Angular offsets between extracted and synthetic skyline from landmark pairs</source>
        <translation>Winkelabweichungen zwischen ausgezogener und synthetischer Horizontlinie aus Paaren von Landmarken</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Each row of the table is one feature, a summit or a notch, clicked on the skyline of the photograph (extracted) and on the projected horizon (synthetic), in pixels of the upright picture. Offsets are synthetic minus extracted: azimuth positive to the right, elevation positive upwards.</source>
        <translation>Jede Zeile der Tabelle ist ein Merkmal, ein Gipfel oder eine Scharte, angeklickt auf der Horizontlinie des Fotos (ausgezogen) und auf dem projizierten Horizont (synthetisch), in Pixeln des aufrecht stehenden Bildes. Abweichungen sind synthetisch minus ausgezogen: im Azimut nach rechts, im Höhenwinkel nach oben positiv.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table needs the fields photo, x_extracted, y_extracted, x_synthetic, y_synthetic (or x1, y1, x2, y2). Picture size and fields of view are read from the fields width, height, hfov and vfov if they exist, otherwise from the photo file by the published rule. The output contains the means of the absolute offsets per photograph; the means over all pairs are returned as results.</source>
        <translation>Die Tabelle braucht die Felder photo, x_extracted, y_extracted, x_synthetic, y_synthetic (oder x1, y1, x2, y2). Bildgröße und Bildwinkel werden aus den Feldern width, height, hfov und vfov gelesen, wenn es sie gibt, sonst nach der veröffentlichten Regel aus der Fotodatei. Die Ausgabe enthält die Mittel der absoluten Abweichungen je Foto; die Mittel über alle Paare werden als Ergebnisse zurückgegeben.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Table of landmark pairs</source>
        <translation>Tabelle der Landmarkenpaare</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>One row per pair; pixels of the upright picture.</source>
        <translation>Eine Zeile je Paar; Pixel des aufrecht stehenden Bildes.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Field {name}</source>
        <translation>Feld {name}</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>If this is empty, the first of {names} that the table contains is used.</source>
        <translation>Wenn leer, wird das erste von {names} verwendet, das die Tabelle enthält.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Offsets per photo</source>
        <translation>Abweichungen je Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>One row per photograph: number of pairs and mean offsets in azimuth, elevation and in total (°).</source>
        <translation>Eine Zeile je Foto: Anzahl der Paare und mittlere Abweichungen in Azimut, Höhe und gesamt (°).</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Number of pairs</source>
        <translation>Anzahl der Paare</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean azimuth offset over all pairs (°)</source>
        <translation>Mittlere Azimutabweichung über alle Paare (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean elevation offset over all pairs (°)</source>
        <translation>Mittlere Höhenwinkelabweichung über alle Paare (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean total offset over all pairs (°)</source>
        <translation>Mittlere Gesamtabweichung über alle Paare (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table has no complete pair. Fill photo and all four coordinates.</source>
        <translation>Die Tabelle hat kein vollständiges Paar. Füllen Sie photo und alle vier Koordinaten aus.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table has no field {field}. It has {fields}; choose the right one under Advanced.</source>
        <translation>Die Tabelle hat kein Feld {field}. Sie hat {fields}; wählen Sie unter Erweitert das richtige.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The photo has no focal length (35 mm equivalent). Give its fields of view in HFOV_FIELD.</source>
        <translation>Das Foto hat keine kleinbildäquivalente Brennweite. Geben Sie seine Bildwinkel in HFOV_FIELD an.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean azimuth offset (°)</source>
        <translation>Mittlere Azimutabweichung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean elevation offset (°)</source>
        <translation>Mittlere Höhenwinkelabweichung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean total offset (°)</source>
        <translation>Mittlere Gesamtabweichung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean signed azimuth offset (°)</source>
        <translation>Mittlere Azimutabweichung mit Vorzeichen (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean signed elevation offset (°)</source>
        <translation>Mittlere Höhenwinkelabweichung mit Vorzeichen (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Merge oriented photos</source>
        <translation>Orientierte Fotos zusammenführen</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>photo,heading,update,merge,rescue,again,ambiguous,rejected,join</source>
        <translation>Foto,Blickrichtung,aktualisieren,zusammenführen,Rettung,erneut,mehrdeutig,abgelehnt,verbinden</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Updates a layer of oriented photos with photos that were oriented again</source>
        <translation>Aktualisiert einen Layer orientierter Fotos mit erneut orientierten Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>When a few photographs have been oriented again, with a hint or a landmark, this puts their answers into the layer that they came from. Photographs are recognised by their path; all others, all other fields and the points' positions stay as they are.</source>
        <translation>Wenn einige Fotos mit einem Hinweis oder einer Landmarke erneut orientiert wurden, kommen ihre Ergebnisse hiermit in den Layer, aus dem sie stammen. Fotos werden an ihrem Pfad erkannt; alle anderen Fotos, alle übrigen Felder und die Positionen der Punkte bleiben, wie sie sind.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>The layer itself is changed. If it is being edited, the changes join your unsaved ones and can be undone. Run &lt;i&gt;Directed viewshed&lt;/i&gt; on it afterwards to renew the ground in view, or use &lt;i&gt;Model: orient photos again&lt;/i&gt;, which does all three steps.</source>
        <translation>Der Layer selbst wird verändert. Wird er gerade bearbeitet, kommen die Änderungen zu Ihren ungespeicherten hinzu und lassen sich rückgängig machen. Führen Sie danach &lt;i&gt;Gerichtetes Sichtfeld&lt;/i&gt; mit ihm aus, um das sichtbare Gelände zu erneuern, oder verwenden Sie &lt;i&gt;Modell: Fotos erneut orientieren&lt;/i&gt;, das alle drei Schritte ausführt.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Oriented photos of an earlier run. This layer is changed.</source>
        <translation>Orientierte Fotos eines früheren Laufs. Dieser Layer wird verändert.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Photos that were oriented again</source>
        <translation>Erneut orientierte Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>The output of Orient photos for some photos of that layer.</source>
        <translation>Die Ausgabe von „Fotos orientieren“ für einige Fotos dieses Layers.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Keep a better status</source>
        <translation>Besseren Status behalten</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>A photo whose new status is worse than its present one keeps its present answer.</source>
        <translation>Ein Foto, dessen neuer Status schlechter ist als der bisherige, behält sein bisheriges Ergebnis.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of updated photos</source>
        <translation>Anzahl aktualisierter Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of photos that keep a better status</source>
        <translation>Anzahl der Fotos, die einen besseren Status behalten</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of photos that the layer does not have</source>
        <translation>Anzahl der Fotos, die der Layer nicht hat</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} cannot be changed. Save it as a GeoPackage first.</source>
        <translation>{name} lässt sich nicht verändern. Speichern Sie den Layer zuerst als GeoPackage.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} has no field {field}. Choose a layer of oriented photos.</source>
        <translation>{name} hat kein Feld {field}. Wählen Sie einen Layer orientierter Fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name}: the layer does not have this photo.</source>
        <translation>{name}: Der Layer hat dieses Foto nicht.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name}: stays {before}; the new answer is {after}.</source>
        <translation>{name}: bleibt {before}; das neue Ergebnis ist {after}.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../core/report/compass.py"/>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{count} photos updated.</source>
        <translation>{count} Fotos aktualisiert.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} occurs more than once; its best status is used.</source>
        <translation>{name} kommt mehrfach vor; der beste Status wird verwendet.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} cannot be changed now.</source>
        <translation>{name} lässt sich jetzt nicht verändern.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>a value does not fit its field</source>
        <translation>ein Wert passt nicht in sein Feld</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} was not changed: {reason}</source>
        <translation>{name} wurde nicht verändert: {reason}</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Orient photos</source>
        <translation>Fotos orientieren</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>photo,heading,azimuth,direction,orientation,pose,skyline,horizon,compass,pitch,roll</source>
        <translation>Foto,Blickrichtung,Azimut,Richtung,Orientierung,Lage,Horizontlinie,Horizont,Kompass,Nickwinkel,Rollwinkel,heading</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Heading, pitch and roll of mountain photographs from their skyline and a DEM</source>
        <translation>Blickrichtung, Nick- und Rollwinkel von Bergfotos aus ihrer Horizontlinie und einem DGM</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Compares the skyline in each photograph with the horizon computed from the elevation model at its position, over all headings, and fits heading, pitch, roll and focal length. No compass is needed.</source>
        <translation>Vergleicht die Horizontlinie jedes Fotos mit dem Horizont, der an seiner Position aus dem Geländemodell berechnet wird, über alle Blickrichtungen, und passt Blickrichtung, Nick- und Rollwinkel und Brennweite an. Ein Kompass ist nicht nötig.</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>&lt;b&gt;status&lt;/b&gt; is &lt;i&gt;accepted&lt;/i&gt; (the answer can be trusted), &lt;i&gt;ambiguous&lt;/i&gt; (another heading fits nearly as well, or the fit is weak; see heading_2 and the report), &lt;i&gt;rejected&lt;/i&gt; (there is no usable skyline, or no heading fits) or &lt;i&gt;failed&lt;/i&gt; (the input cannot be used). &lt;b&gt;message&lt;/b&gt; gives the reason and suggests what to do. heading_lo and heading_hi enclose the true heading with a probability of 90 %. For an accepted photo this holds if its heading is the right one; &lt;b&gt;p_correct&lt;/b&gt; is the probability of that.</source>
        <translation>&lt;b&gt;status&lt;/b&gt; ist &lt;i&gt;accepted&lt;/i&gt; (angenommen: die Antwort ist verlässlich), &lt;i&gt;ambiguous&lt;/i&gt; (mehrdeutig: eine andere Blickrichtung passt fast ebenso gut, oder die Anpassung ist schwach; siehe heading_2 und den Bericht), &lt;i&gt;rejected&lt;/i&gt; (verworfen: es gibt keine brauchbare Horizontlinie, oder keine Blickrichtung passt) oder &lt;i&gt;failed&lt;/i&gt; (gescheitert: die Eingabe ist nicht verwendbar). &lt;b&gt;message&lt;/b&gt; nennt den Grund und schlägt vor, was zu tun ist. heading_lo und heading_hi schließen die wahre Blickrichtung mit einer Wahrscheinlichkeit von 90 % ein. Bei einem angenommenen Foto gilt das, wenn seine Blickrichtung die richtige ist; &lt;b&gt;p_correct&lt;/b&gt; ist die Wahrscheinlichkeit dafür.</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Headings count clockwise from true north. A point's geometry is the camera's position. For photos that fail, give an approximate heading, a landmark, a drawn skyline or a sky mask (Advanced).</source>
        <translation>Blickrichtungen zählen im Uhrzeigersinn von geographisch Nord. Die Geometrie eines Punktes ist der Standort der Kamera. Für Fotos, die scheitern, geben Sie eine ungefähre Blickrichtung, eine Landmarke, eine gezeichnete Horizontlinie oder eine Himmelsmaske an (Erweitert).</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>Orientability</source>
        <translation>Orientierbarkeit</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>planning,camera,webcam,repeat photography,horizon,ambiguity,accuracy,prediction</source>
        <translation>Planung,Kamera,Webcam,Wiederholungsfotografie,Horizont,Mehrdeutigkeit,Genauigkeit,Vorhersage</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>How well a photo from a place could be oriented, by direction and field of view, from the DEM alone</source>
        <translation>Wie gut sich ein Foto von einem Ort orientieren ließe, nach Richtung und Bildwinkel, allein aus dem DGM</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Compares each stretch of the horizon with all others, as a photograph of it would be compared, and predicts the probability that its heading is found and the error of that heading. Use it to plan cameras and repeat photography.</source>
        <translation>Vergleicht jedes Stück des Horizonts mit allen anderen, wie ein Foto davon verglichen würde, und sagt die Wahrscheinlichkeit, dass seine Blickrichtung gefunden wird, und deren Fehler vorher. Damit lassen sich Kameras und Wiederholungsfotos planen.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>A horizon that repeats itself, a flat one and a narrow field of view are hard to orient, and the probability tells them from distinct ones. Where the terrain is distinct, photographs still fail on clouds, trees and near slopes, which the DEM does not show.</source>
        <translation>Ein Horizont, der sich wiederholt, ein flacher Horizont und ein schmaler Bildwinkel sind schwer zu orientieren; die Wahrscheinlichkeit unterscheidet sie von eindeutigen. Wo das Gelände eindeutig ist, scheitern Fotos immer noch an Wolken, Bäumen und nahen Hängen, die das DEM nicht zeigt.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Horizontal fields of view (°)</source>
        <translation>Horizontale Bildwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Numbers between 5 and 120, separated by commas.</source>
        <translation>Zahlen zwischen 5 und 120, durch Kommas getrennt.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Standard deviation of the camera's position; it matters if terrain is near.</source>
        <translation>Standardabweichung der Kameraposition; sie zählt, wenn Gelände nahe ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Extent of the raster</source>
        <translation>Ausschnitt des Rasters</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Area of the optional raster.</source>
        <translation>Gebiet des optionalen Rasters.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Size of the cells of the raster, rounded to whole cells of the DEM.</source>
        <translation>Größe der Zellen des Rasters, auf ganze Zellen des DGM gerundet.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Cells of the raster (m)</source>
        <translation>Zellen des Rasters (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>One point per place and field of view, with the probability in eight directions.</source>
        <translation>Ein Punkt je Ort und Bildwinkel mit der Wahrscheinlichkeit in acht Richtungen.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Orientability of places</source>
        <translation>Orientierbarkeit der Orte</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Bands: mean probability, probability in eight directions, and expected error (°), for the first field of view.</source>
        <translation>Bänder: mittlere Wahrscheinlichkeit, Wahrscheinlichkeit in acht Richtungen und erwarteter Fehler (°), für den ersten Bildwinkel.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Number of places</source>
        <translation>Anzahl der Orte</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Choose places, or an extent and a raster to write.</source>
        <translation>Wählen Sie Orte, oder einen Ausschnitt und ein Raster, das geschrieben wird.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Choose the extent of the raster.</source>
        <translation>Wählen Sie den Ausschnitt des Rasters.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>The fields of view must be numbers between 5 and 120, separated by commas.</source>
        <translation>Die Bildwinkel müssen Zahlen zwischen 5 und 120 sein, durch Kommas getrennt.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Probability of a unique answer towards {direction}</source>
        <translation>Wahrscheinlichkeit einer eindeutigen Antwort in Richtung {direction}</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Mean probability of a unique answer</source>
        <translation>Mittlere Wahrscheinlichkeit einer eindeutigen Antwort</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Expected error of the heading (°)</source>
        <translation>Erwarteter Fehler der Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Outline panorama</source>
        <translation>Konturpanorama</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>panorama,horizon,skyline,ridge,outline,360,peaks,labels,svg</source>
        <translation>Panorama,Horizont,Horizontlinie,Grat,Umriss,360,Gipfel,Beschriftung,SVG</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Labelled horizon and inner ridges in all directions from a point, as SVG, PNG and map lines</source>
        <translation>Beschrifteter Horizont und innere Grate in allen Richtungen von einem Punkt aus, als SVG, PNG und Kartenlinien</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>For each point, draws the horizon and every inner ridge that hides ground behind it. Near ridges are dark and thick, distant ones pale. Summits come from a layer, or are found in the DEM by their prominence. Optionally, the frames of oriented photos near the point are drawn.</source>
        <translation>Zeichnet für jeden Punkt den Horizont und jeden inneren Grat, der Gelände dahinter verdeckt. Nahe Grate sind dunkel und dick, ferne blass. Gipfel kommen aus einem Layer oder werden nach ihrer Schartenhöhe im DGM gesucht. Optional werden die Bildausschnitte orientierter Fotos in der Nähe des Punkts gezeichnet.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The line layer holds the same ridges on the map, with distance and elevation angle.</source>
        <translation>Der Linienlayer enthält dieselben Grate auf der Karte, mit Entfernung und Höhenwinkel.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The frames of photos within 100 m of a point are drawn, from the fields heading, pitch, roll, hfov and vfov.</source>
        <translation>Die Bildausschnitte von Fotos im Umkreis von 100 m um einen Punkt werden gezeichnet, nach den Feldern heading, pitch, roll, hfov und vfov.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Angle between neighbouring rays.</source>
        <translation>Winkel zwischen benachbarten Strahlen.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth at the left edge (°)</source>
        <translation>Azimut am linken Rand (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth at which the panorama begins.</source>
        <translation>Azimut, bei dem das Panorama beginnt.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Pixels per degree</source>
        <translation>Pixel je Grad</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Size of the drawing.</source>
        <translation>Größe der Zeichnung.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Exaggeration of heights</source>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>1: true shape.</source>
        <translation>1: wahre Form.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>One PNG and one SVG per point.</source>
        <translation>Ein PNG und ein SVG je Punkt.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Folder for panoramas</source>
        <translation>Ordner für Panoramen</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Ridges in view</source>
        <translation>Sichtbare Grate</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The drawn ridges as lines on the map, with distance (m) and elevation angle (°).</source>
        <translation>Die gezeichneten Grate als Linien auf der Karte, mit Entfernung (m) und Höhenwinkel (°).</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Number of panoramas</source>
        <translation>Anzahl der Panoramen</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>horizon or ridge</source>
        <translation>horizon (Horizont) oder ridge (Grat)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Begins at azimuth (° from true north)</source>
        <translation>Beginnt bei Azimut (° von geographisch Nord)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Ends at azimuth (° from true north)</source>
        <translation>Endet bei Azimut (° von geographisch Nord)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Median distance (m)</source>
        <translation>Median der Entfernung (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Highest elevation angle (°)</source>
        <translation>Größter Höhenwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Coverage of a photo collection</source>
        <translation>Abdeckung einer Fotosammlung</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>coverage,blind spot,viewshed,cumulative,set cover,monitoring,fewest,photos,gsd</source>
        <translation>Abdeckung,blinder Fleck,Sichtfeld,kumulativ,Mengenüberdeckung,Monitoring,wenigste Fotos,Bodenauflösung</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>How often and how finely each cell is photographed, blind spots, and the fewest photos needed</source>
        <translation>Wie oft und wie fein jede Zelle fotografiert ist, blinde Flecken und die wenigsten nötigen Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Counts the photographs that see each cell of the area (0 is a blind spot) and gives the finest ground sampling distance among them in metres per pixel, across the line of sight.</source>
        <translation>Zählt die Fotos, die jede Zelle des Gebiets zeigen (0 ist ein blinder Fleck), und gibt die feinste Bodenauflösung unter ihnen in Metern je Pixel quer zur Sichtlinie.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>The table gives how much each photograph shows, and which photographs are needed: as few as possible that together show everything the collection shows, in the order of how much each adds (&lt;b&gt;pick&lt;/b&gt;). PROVEN is true if it was proven that no smaller selection exists.</source>
        <translation>Die Tabelle gibt an, wie viel jedes Foto zeigt und welche Fotos nötig sind: so wenige wie möglich, die zusammen alles zeigen, was die Sammlung zeigt, in der Reihenfolge ihres Beitrags (&lt;b&gt;pick&lt;/b&gt;). PROVEN ist wahr, wenn bewiesen wurde, dass es keine kleinere Auswahl gibt.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Only ground inside the area counts. If this is empty, all ground of the DEM within the maximum distance of the photos counts.</source>
        <translation>Nur Gelände innerhalb des Gebiets zählt. Wenn leer, zählt alles Gelände des DGM innerhalb der größten Entfernung von den Fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Number of photographs that show each cell, on the DEM's grid. 0 is a blind spot; nodata is outside the area.</source>
        <translation>Anzahl der Fotos, die jede Zelle zeigen, auf dem Gitter des DGM. 0 ist ein blinder Fleck; NoData liegt außerhalb des Gebiets.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Best ground sampling distance</source>
        <translation>Beste Bodenauflösung</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Metres per pixel of the best photo, across the view.</source>
        <translation>Meter je Pixel des besten Fotos, quer zum Blick.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Photos and what they add</source>
        <translation>Fotos und ihr Beitrag</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>One row per photograph with the ground that it shows and, if it is needed, its place in the selection.</source>
        <translation>Eine Zeile je Foto mit dem Gelände, das es zeigt, und, falls es nötig ist, seinem Platz in der Auswahl.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Share of the area seen by at least one</source>
        <translation>Anteil des Gebiets, den mindestens eines zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Number of cells that no photo sees</source>
        <translation>Anzahl der Zellen, die kein Foto zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Fewest photos that see all that the collection sees</source>
        <translation>Wenigste Fotos, die alles zeigen, was die Sammlung zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>No smaller choice exists</source>
        <translation>Es gibt keine kleinere Auswahl</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>None of the points is an oriented photo of a chosen status on this DEM.</source>
        <translation>Keiner der Punkte ist ein orientiertes Foto mit gewähltem Status auf diesem Höhenmodell.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>The area is empty, or lies outside the region for which the DEM's CRS is valid.</source>
        <translation>Das Gebiet ist leer oder liegt außerhalb des Bereichs, für den das KBS des DGM gültig ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>photo,viewshed,heading,orientation,skyline,visibility,heic,exif,report,batch</source>
        <translation>Foto,Sichtfeld,Blickrichtung,Orientierung,Horizontlinie,Sichtbarkeit,HEIC,EXIF,Bericht,Stapel,viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>From mountain photographs and a DEM to headings, ground in view and a report</source>
        <translation>Von Bergfotos und einem DGM zu Blickrichtungen, sichtbarem Gelände und einem Bericht</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Reads geotagged photographs, finds the heading of each from its skyline and the elevation model, and computes the ground that it shows. Choose a folder or a layer of photo points.</source>
        <translation>Liest georeferenzierte Fotos, findet die Blickrichtung jedes Fotos aus seiner Horizontlinie und dem Geländemodell und berechnet das Gelände, das es zeigt. Wählen Sie einen Ordner oder einen Layer mit Fotopunkten.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Open the report to check each match: it has one card per photograph, with the horizon drawn over the picture. Photographs with a doubtful heading (status &lt;i&gt;ambiguous&lt;/i&gt;) get no viewshed unless you request it under Advanced. With the &lt;i&gt;paper&lt;/i&gt; method, which does not test its answers, all photographs get one.</source>
        <translation>Öffnen Sie den Bericht, um jede Zuordnung zu prüfen: Er enthält eine Karte je Foto, mit dem Horizont über dem Bild. Fotos mit zweifelhafter Blickrichtung (Status &lt;i&gt;ambiguous&lt;/i&gt;) erhalten kein Sichtfeld, wenn Sie es nicht unter Erweitert verlangen. Beim Verfahren &lt;i&gt;Aufsatz&lt;/i&gt;, das seine Antworten nicht prüft, erhalten alle Fotos eines.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Distances are ground metres and headings count from true north, whatever the coordinate systems.</source>
        <translation>Entfernungen sind Meter am Boden, Blickrichtungen zählen von geographisch Nord, in jedem Koordinatensystem.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Maximum viewshed distance from the camera, in metres on the ground.</source>
        <translation>Größte Entfernung des Sichtfelds von der Kamera, in Metern am Boden.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Viewsheds of doubtful photos too</source>
        <translation>Sichtfelder auch für zweifelhafte Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Search range of the horizon (m)</source>
        <translation>Suchweite des Horizonts (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Computes the ground for the best heading even if another heading is as likely.</source>
        <translation>Berechnet das Gelände für die beste Blickrichtung, auch wenn eine andere ebenso wahrscheinlich ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Pixels to map (monoplotting)</source>
        <translation>Pixel zur Karte (Monoplotting)</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>monoplotting,pixel,photo,georeference,digitise,glacier,labelme,coco,via,ellipse,accuracy</source>
        <translation>Monoplotting,Pixel,Foto,Georeferenz,digitalisieren,Gletscher,LabelMe,COCO,VIA,Ellipse,Genauigkeit</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Points, lines and areas drawn on oriented photos become map features with an error ellipse</source>
        <translation>Auf orientierte Fotos gezeichnete Punkte, Linien und Flächen werden zu Kartenobjekten mit Fehlerellipse</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Follows the line of sight of each pixel to the elevation model, with the earth's curvature and refraction. Lines and outlines are followed pixel by pixel and cut where the ground behind them jumps. If a pixel shows the sky, or its line of sight enters a void of the DEM or reaches its edge, the field &lt;b&gt;status&lt;/b&gt; records this.</source>
        <translation>Verfolgt die Sichtlinie jedes Pixels bis zum Geländemodell, mit Erdkrümmung und Refraktion. Linien und Umrisse werden Pixel für Pixel verfolgt und zerschnitten, wo das Gelände dahinter springt. Wenn ein Pixel den Himmel zeigt oder seine Sichtlinie in eine Lücke des DGM gerät oder dessen Rand erreicht, steht das im Feld &lt;b&gt;status&lt;/b&gt;.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>The error ellipse contains the true position with the chosen probability, given the uncertainties of heading, pitch, roll, focal length, position and DEM. &lt;b&gt;p_other&lt;/b&gt; is the probability that the pixel shows different ground, beyond an edge in the picture. It is often large near ridges.</source>
        <translation>Die Fehlerellipse enthält die wahre Position mit der gewählten Wahrscheinlichkeit, bei den Unsicherheiten von Blickrichtung, Nick- und Rollwinkel, Brennweite, Position und DGM. &lt;b&gt;p_other&lt;/b&gt; ist die Wahrscheinlichkeit, dass das Pixel anderes Gelände zeigt, jenseits einer Kante im Bild. Sie ist nahe an Graten oft groß.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Probability of the error ellipse (%)</source>
        <translation>Wahrscheinlichkeit der Fehlerellipse (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Probability that the ellipse contains the true position; 90 % is usual.</source>
        <translation>Wahrscheinlichkeit, dass die Ellipse die wahre Position enthält; üblich sind 90 %.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Lines and outlines are followed in steps of this length.</source>
        <translation>Linien und Umrisse werden in Schritten dieser Länge verfolgt.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Points on the map</source>
        <translation>Punkte auf der Karte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Where the lines of sight of drawn points meet the ground, with status and distance (m).</source>
        <translation>Wo die Sichtlinien gezeichneter Punkte das Gelände treffen, mit Status und Entfernung (m).</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Lines on the map</source>
        <translation>Linien auf der Karte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Drawn lines on the ground, cut where the ground behind them jumps.</source>
        <translation>Gezeichnete Linien am Boden, getrennt, wo das Gelände hinter ihnen springt.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Areas on the map</source>
        <translation>Flächen auf der Karte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Drawn areas on the ground.</source>
        <translation>Gezeichnete Flächen am Boden.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Error ellipses</source>
        <translation>Fehlerellipsen</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>One ellipse per point, which contains the true position with the chosen probability.</source>
        <translation>Eine Ellipse je Punkt, die die wahre Position mit der gewählten Wahrscheinlichkeit enthält.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Number of map features</source>
        <translation>Anzahl der Kartenobjekte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Number of features that show no ground</source>
        <translation>Anzahl der Objekte, die kein Gelände zeigen</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Check photo positions</source>
        <translation>Fotopositionen prüfen</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>position,gps,check,wrong,shift,photo,skyline,horizon,quality</source>
        <translation>Position,GPS,prüfen,falsch,Verschiebung,Foto,Horizontlinie,Horizont,Qualität</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Whether the recorded position of a photo agrees with its skyline, and where a better place is</source>
        <translation>Ob die aufgezeichnete Position eines Fotos zu seiner Horizontlinie passt, und wo ein besserer Ort ist</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Orients each photograph from its recorded position and then tries places around it. If the skyline fits much better somewhere else, &lt;b&gt;verdict&lt;/b&gt; is &lt;i&gt;doubtful&lt;/i&gt;, and &lt;b&gt;dx&lt;/b&gt; and &lt;b&gt;dy&lt;/b&gt; give the way there in metres to the east and north. Positions are reported and never changed.</source>
        <translation>Orientiert jedes Foto von seiner aufgezeichneten Position und probiert dann Orte um sie herum. Passt die Horizontlinie anderswo viel besser, ist &lt;b&gt;verdict&lt;/b&gt; &lt;i&gt;doubtful&lt;/i&gt;, und &lt;b&gt;dx&lt;/b&gt; und &lt;b&gt;dy&lt;/b&gt; geben den Weg dorthin in Metern nach Osten und Norden an. Positionen werden gemeldet und nie geändert.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>A skyline of far mountains says little about a position: a &lt;i&gt;believable&lt;/i&gt; verdict only means that no place nearby fits much better. The error ellipse says how well the skyline fixes the better place.</source>
        <translation>Eine Horizontlinie aus fernen Bergen sagt wenig über eine Position: Das Urteil &lt;i&gt;believable&lt;/i&gt; bedeutet nur, dass kein Ort in der Nähe viel besser passt. Die Fehlerellipse sagt, wie gut die Horizontlinie den besseren Ort festlegt.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Rings of places are tried out to this distance; the larger it is, the farther apart they lie.</source>
        <translation>Bis zu diesem Abstand werden Ringe von Orten geprüft; je größer er ist, desto weiter liegen sie auseinander.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Search radius (m)</source>
        <translation>Suchradius (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Checked positions</source>
        <translation>Geprüfte Positionen</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>The photo points with the verdict and the way to the better place.</source>
        <translation>Die Fotopunkte mit dem Urteil und dem Weg zum besseren Ort.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Number of doubtful positions</source>
        <translation>Anzahl der zweifelhaften Positionen</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Better place, metres to the east</source>
        <translation>Besserer Ort, Meter nach Osten</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Better place, metres to the north</source>
        <translation>Besserer Ort, Meter nach Norden</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Gain in agreement there</source>
        <translation>Gewinn an Übereinstimmung dort</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Error ellipse (90 %), longer half axis (m)</source>
        <translation>Fehlerellipse (90 %), längere Halbachse (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Error ellipse (90 %), shorter half axis (m)</source>
        <translation>Fehlerellipse (90 %), kürzere Halbachse (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Azimuth of the longer half axis (°)</source>
        <translation>Azimut der längeren Halbachse (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Position photos from a track</source>
        <translation>Fotos anhand eines Tracks verorten</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>photo,gps,gpx,track,time,clock,geotag,position,exif,time zone</source>
        <translation>Foto,GPS,GPX,Track,Zeit,Uhr,Geotag,Position,EXIF,Zeitzone</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Points of photographs without GPS, from the times of a recorded track</source>
        <translation>Punkte von Fotos ohne GPS, anhand der Zeiten eines aufgezeichneten Tracks</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Makes one point per photograph at the place of the track at the photograph's time. The point's error (&lt;b&gt;pos_err&lt;/b&gt;) grows with the gap between the track points around it; &lt;i&gt;Orient photos&lt;/i&gt; takes it into account. If the track gives no position for that time, the point has no geometry and &lt;b&gt;pos_note&lt;/b&gt; says why.</source>
        <translation>Erzeugt für jedes Foto einen Punkt an der Stelle des Tracks zur Aufnahmezeit. Der Fehler des Punkts (&lt;b&gt;pos_err&lt;/b&gt;) wächst mit der Lücke zwischen den Trackpunkten ringsum; &lt;i&gt;Fotos orientieren&lt;/i&gt; berücksichtigt ihn. Wenn der Track für diese Zeit keine Position ergibt, hat der Punkt keine Geometrie, und &lt;b&gt;pos_note&lt;/b&gt; nennt den Grund.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Cameras record local time. The time zone is read from the file, or taken from the parameter. If the clock was wrong, give its offset, or have it found &lt;i&gt;from the skylines&lt;/i&gt;: this needs an elevation model and at least three photographs with a clear skyline from different places, and takes a few minutes. If other offsets fit as well, no photograph is placed and a warning says so.</source>
        <translation>Kameras zeichnen die Ortszeit auf. Die Zeitzone wird aus der Datei gelesen oder dem Parameter entnommen. Ging die Uhr falsch, geben Sie ihre Abweichung an oder lassen Sie sie &lt;i&gt;aus den Horizontlinien&lt;/i&gt; bestimmen: Dazu sind ein Höhenmodell und mindestens drei Fotos mit klarer Horizontlinie von verschiedenen Orten nötig; es dauert einige Minuten. Passen andere Abweichungen ebenso gut, wird kein Foto verortet, und eine Warnung weist darauf hin.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>JPEG and HEIC files; a GPS position is not needed.</source>
        <translation>JPEG- und HEIC-Dateien; eine GPS-Position ist nicht nötig.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Layer or table with the paths of the photographs, in place of a folder.</source>
        <translation>Layer oder Tabelle mit den Pfaden der Fotos anstelle eines Ordners.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Time zone of the camera's clock</source>
        <translation>Zeitzone der Kamerauhr</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>For example +05:45 or Asia/Kathmandu. Empty: as the photograph records it.</source>
        <translation>Zum Beispiel +05:45 oder Asia/Kathmandu. Leer: wie im Foto aufgezeichnet.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Camera's clock</source>
        <translation>Uhr der Kamera</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>as given</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>find its offset from the skylines</source>
        <translation>Abweichung aus den Horizontlinien bestimmen</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The skylines show where the photographs were taken, and so how much the clock is ahead: up to 14 hours to either side. At most 20 photographs are used, spread over the walk and at least a minute apart.</source>
        <translation>Die Horizontlinien zeigen, wo die Fotos aufgenommen wurden, und damit, wie weit die Uhr vorgeht: bis zu 14 Stunden nach beiden Seiten. Höchstens 20 Fotos werden verwendet, über die Wanderung verteilt und mindestens eine Minute auseinander.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Seconds by which the camera's clock is ahead of the true time; negative if it is behind.</source>
        <translation>Sekunden, um die die Kamerauhr der wahren Zeit voraus ist; negativ, wenn sie nachgeht.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Clock is ahead by (s)</source>
        <translation>Die Uhr geht vor um (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Needed only to find the clock's offset from the skylines.</source>
        <translation>Nur nötig, um die Abweichung der Uhr aus den Horizontlinien zu bestimmen.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Longest time between two track points that is interpolated; beyond the track's ends, half of it.</source>
        <translation>Längste Zeit zwischen zwei Trackpunkten, über die interpoliert wird; jenseits der Enden des Tracks die Hälfte davon.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Interpolation limit (s)</source>
        <translation>Grenze der Interpolation (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Standard deviation of the track's points.</source>
        <translation>Standardabweichung der Trackpunkte.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Error of the track (m)</source>
        <translation>Fehler des Tracks (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>One point per photograph, with the source of its position and its error; without geometry if there is no position.</source>
        <translation>Ein Punkt je Foto mit Herkunft und Fehler seiner Position; ohne Geometrie, wenn es keine Position gibt.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Positioned photos</source>
        <translation>Verortete Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Number of photos with a position</source>
        <translation>Anzahl der Fotos mit Position</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Offset of the clock that was used (s)</source>
        <translation>Verwendete Abweichung der Uhr (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Standard deviation of the clock's offset (s)</source>
        <translation>Standardabweichung der Abweichung der Uhr (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Choose either a folder of photographs or a layer with their paths.</source>
        <translation>Wählen Sie entweder einen Ordner mit Fotos oder einen Layer mit ihren Pfaden.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>To find the clock's offset from the skylines, choose an elevation model.</source>
        <translation>Um die Abweichung der Uhr aus den Horizontlinien zu bestimmen, wählen Sie ein Höhenmodell.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>{placed} of {count} photos have a position.</source>
        <translation>{placed} von {count} Fotos haben eine Position.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The photo records no time.</source>
        <translation>Das Foto enthält keine Aufnahmezeit.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The photo records no time zone. Give the time zone of the camera's clock.</source>
        <translation>Das Foto enthält keine Zeitzone. Geben Sie die Zeitzone der Kamerauhr an.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>from the track</source>
        <translation>aus dem Track</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Time between the track points around the photo (s)</source>
        <translation>Zeit zwischen den Trackpunkten um das Foto (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Where the position comes from, or why there is none</source>
        <translation>Herkunft der Position, oder warum es keine gibt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>One row per device, from accepted and confirmed photos: bias of the compass with its 90 % interval, spread, worthless and turned readings, and drift over the day.</source>
        <translation>Eine Zeile je Gerät aus angenommenen und bestätigten Fotos: systematische Abweichung des Kompasses mit ihrem 90-%-Intervall, Streuung, wertlose und verdrehte Ablesungen und Änderung im Lauf des Tages.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Compass audit</source>
        <translation>Kompassprüfung</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Maker, model and software</source>
        <translation>Hersteller, Modell und Software</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <location filename="../core/report/compass.py"/>
        <source>Readings</source>
        <translation>Ablesungen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Recorded minus found heading, median (°)</source>
        <translation>Aufgezeichnete minus gefundene Blickrichtung, Median (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Lower limit of the bias, 90 % (°)</source>
        <translation>Untere Grenze der Abweichung, 90 % (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Upper limit of the bias, 90 % (°)</source>
        <translation>Obere Grenze der Abweichung, 90 % (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Robust standard deviation (°)</source>
        <translation>Robuste Standardabweichung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings off by more than 30°</source>
        <translation>Ablesungen, die um mehr als 30° danebenliegen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias + 90°</source>
        <translation>Ablesungen nahe Abweichung + 90°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias − 90°</source>
        <translation>Ablesungen nahe Abweichung − 90°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias + 180°</source>
        <translation>Ablesungen nahe Abweichung + 180°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Too many of these for chance</source>
        <translation>Davon zu viele für einen Zufall</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Change of the bias during a day (° per hour)</source>
        <translation>Änderung der Abweichung im Lauf eines Tages (° je Stunde)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Lower limit of the change, 90 % (° per hour)</source>
        <translation>Untere Grenze der Änderung, 90 % (° je Stunde)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Upper limit of the change, 90 % (° per hour)</source>
        <translation>Obere Grenze der Änderung, 90 % (° je Stunde)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <source>{count} photos are oriented first to test the compasses of the cameras.</source>
        <translation>Zuerst werden {count} Fotos ausgerichtet, um die Kompasse der Kameras zu prüfen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Cancelled after {done} of {count} photos.</source>
        <translation>Abgebrochen nach {done} von {count} Fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <source>{camera}: about {percent} % of the compass readings are treated as worthless, because they contradict the skylines.</source>
        <translation>{camera}: Etwa {percent} % der Kompassangaben gelten als wertlos, weil sie den Horizontlinien widersprechen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photo point</source>
        <translation>Fotopunkt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Cells of the area that it sees</source>
        <translation>Zellen des Gebiets, die es zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Share of the area that it sees</source>
        <translation>Anteil des Gebiets, den es zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Place among the fewest photos needed; NULL: not needed</source>
        <translation>Platz unter den wenigsten nötigen Fotos; NULL: nicht nötig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Cells that it adds to those picked before</source>
        <translation>Zellen, die es zu den zuvor gewählten hinzufügt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Share of the area seen by the picks up to here</source>
        <translation>Anteil des Gebiets, den die Auswahl bis hierher zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>photographs that see the cell</source>
        <translation>Fotos, die die Zelle sehen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>metres per pixel across the view, best photo</source>
        <translation>Meter je Pixel quer zum Blick, bestes Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>No photo shows any ground of this DEM, so there is nothing to drape.</source>
        <translation>Kein Foto zeigt Gelände dieses DGM; es gibt nichts aufzulegen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>metres per pixel across the view</source>
        <translation>Meter je Pixel quer zum Blick</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>metres per pixel along the view</source>
        <translation>Meter je Pixel längs des Blicks</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/elevation.py"/>
        <source>The elevation model cannot be read. Choose a raster file with heights.</source>
        <translation>Das Geländemodell kann nicht gelesen werden. Wählen Sie eine Rasterdatei mit Höhen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/elevation.py"/>
        <source>The elevation model comes from a {provider} source. Save it as a GeoTIFF first and choose that.</source>
        <translation>Das Geländemodell kommt aus einer {provider}-Quelle. Speichern Sie es zuerst als GeoTIFF und wählen Sie dieses.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/feedback.py"/>
        <source>{name} ({number}/{count})</source>
        <translation>{name} ({number}/{count})</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/field_names.py"/>
        <source>Fields renamed because the format of the output reserves the name: {names}</source>
        <translation>Felder wurden umbenannt, weil das Ausgabeformat den Namen für sich behält: {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <source>Choose a folder of photographs or a layer of photo points.</source>
        <translation>Wählen Sie einen Ordner mit Fotos oder einen Layer mit Fotopunkten.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <source>Choose either a folder of photographs or a layer of photo points, not both.</source>
        <translation>Wählen Sie entweder einen Ordner mit Fotos oder einen Layer mit Fotopunkten, nicht beides.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>The folder {folder} does not exist.</source>
        <translation>Den Ordner {folder} gibt es nicht.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Map feature</source>
        <translation>Kartenobjekt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>visible, hidden, outside the frame, unknown</source>
        <translation>visible (sichtbar), hidden (verdeckt), outside (außerhalb des Bildes), unknown (unbekannt)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance from the camera (m)</source>
        <translation>Entfernung von der Kamera (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Elevation (m)</source>
        <translation>Höhe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Line or ring of the feature</source>
        <translation>Linie oder Ring des Objekts</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Begins at this share of its length</source>
        <translation>Beginnt bei diesem Anteil seiner Länge</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Ends at this share of its length</source>
        <translation>Endet bei diesem Anteil seiner Länge</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Nearest distance (m)</source>
        <translation>Kleinste Entfernung (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Farthest distance (m)</source>
        <translation>Größte Entfernung (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Share of the whole feature that is visible</source>
        <translation>Sichtbarer Anteil des ganzen Objekts</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>The map features are empty, or lie outside the region for which the DEM's CRS is valid.</source>
        <translation>Die Kartenobjekte sind leer oder liegen außerhalb des Bereichs, für den das KBS des DGM gültig ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <source>One file per photo (about 2 MB), for this plugin only. A repeated run reuses each orientation for which nothing has changed (photo, DEM, settings, version of the plugin), so a run that was stopped continues where it stopped.</source>
        <translation>Eine Datei je Foto (etwa 2 MB), nur für diese Erweiterung. Ein wiederholter Lauf verwendet jede Orientierung wieder, für die sich nichts geändert hat (Foto, DGM, Einstellungen, Version der Erweiterung), sodass ein abgebrochener Lauf dort weitermacht, wo er abgebrochen wurde.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <source>Folder for finished orientations</source>
        <translation>Ordner für fertige Orientierungen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <location filename="../algorithms/shared/viewer.py"/>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>{name}: taken from {path}</source>
        <translation>{name}: übernommen aus {path}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <location filename="../algorithms/shared/places_along.py"/>
        <source>The layer of points has no feature. Choose another, or clear the selection.</source>
        <translation>Der Punktlayer hat kein Objekt. Wählen Sie einen anderen oder heben Sie die Auswahl auf.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>Point {id}</source>
        <translation>Punkt {id}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The layer has no field {field} ({name}). Choose another.</source>
        <translation>Der Layer hat kein Feld {field} ({name}). Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <location filename="../panel/model/photo_layer.py"/>
        <source>The point layer has no coordinate reference system. Assign the right one in the layer's properties.</source>
        <translation>Der Punktlayer hat kein Koordinatenbezugssystem. Weisen Sie in den Layereigenschaften das richtige zu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The field {field} holds pictures, not paths. Save the pictures as files and choose a field with their paths (PHOTO_FIELD).</source>
        <translation>Das Feld {field} enthält Bilder, keine Pfade. Speichern Sie die Bilder als Dateien und wählen Sie ein Feld mit ihren Pfaden (PHOTO_FIELD).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The layer has no field {field}. Choose the field that holds the photographs' paths.</source>
        <translation>Der Layer hat kein Feld {field}. Wählen Sie das Feld mit den Pfaden der Fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>visible</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden</source>
        <translation>verdeckt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>outside the picture</source>
        <translation>außerhalb des Bildes</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>accepted: trust it</source>
        <translation>angenommen: vertrauenswürdig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>confirmed by a person</source>
        <translation>von einer Person bestätigt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>ambiguous: look at the report</source>
        <translation>mehrdeutig: siehe Bericht</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>rejected: no answer</source>
        <translation>verworfen: keine Antwort</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>failed: input at fault</source>
        <translation>gescheitert: Eingabe fehlerhaft</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>1 photo</source>
        <translation>1 Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>2 photos</source>
        <translation>2 Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>3 photos</source>
        <translation>3 Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>4 to 5 photos</source>
        <translation>4 bis 5 Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>6 to 10 photos</source>
        <translation>6 bis 10 Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>more than 10 photos</source>
        <translation>mehr als 10 Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 200 m or more too low</source>
        <translation>verdeckt, 200 m oder mehr zu niedrig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 50 m too low</source>
        <translation>verdeckt, 50 m zu niedrig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 10 m too low</source>
        <translation>verdeckt, 10 m zu niedrig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>just hidden</source>
        <translation>gerade noch verdeckt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>just seen</source>
        <translation>gerade noch gesehen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen, 10 m to spare</source>
        <translation>gesehen, 10 m übrig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen, 100 m or more to spare</source>
        <translation>gesehen, 100 m oder mehr übrig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>1 (open sky)</source>
        <translation>1 (freier Himmel)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>Answer</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Match</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Table of lenses</source>
        <translation>Tabelle der Objektive</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Distortion of known lenses, for example a CSV file: fields k1 and k2 (Brown, as in OpenCV), and at least one of make, model, lens, focal (mm) and f35 (mm), as in the photos' EXIF data; empty values fit all. The row that names most of a photo is used. Values in fields k1 and k2 of the points take precedence.</source>
        <translation>Verzeichnung bekannter Objektive, zum Beispiel eine CSV-Datei: Felder k1 und k2 (Brown, wie in OpenCV) und mindestens eines von make, model, lens, focal (mm) und f35 (mm), wie in den EXIF-Daten der Fotos; leere Werte passen zu allen. Es gilt die Zeile, die am meisten von einem Foto nennt. Werte in den Feldern k1 und k2 der Punkte haben Vorrang.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>{count} of {total} photos take k1 and k2 from the table of lenses.</source>
        <translation>{count} von {total} Fotos erhalten k1 und k2 aus der Tabelle der Objektive.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>No row of the table of lenses fits {count} photos, which are treated as free of distortion: {names}.</source>
        <translation>Keine Zeile der Tabelle der Objektive passt zu {count} Fotos, die als frei von Verzeichnung behandelt werden: {names}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Rows {first} and {second} of LENS_TABLE fit {photo} equally well. Name more of its lens in one.</source>
        <translation>Die Zeilen {first} und {second} von LENS_TABLE passen gleich gut zu {photo}. Nennen Sie in einer mehr von seinem Objektiv.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>no camera in the file</source>
        <translation>keine Kamera in der Datei</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Radial distortion k1</source>
        <translation>Radiale Verzeichnung k1</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Radial distortion k2</source>
        <translation>Radiale Verzeichnung k2</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>The table LENS_TABLE needs the fields k1 and k2 and at least one of make, model, lens, focal and f35; it has {fields}.</source>
        <translation>Die Tabelle LENS_TABLE braucht die Felder k1 und k2 und mindestens eines von make, model, lens, focal und f35; sie hat {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>The table LENS_TABLE has no row.</source>
        <translation>Die Tabelle LENS_TABLE hat keine Zeile.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Rows {first} and {second} of LENS_TABLE give one lens different distortions. Delete one.</source>
        <translation>Die Zeilen {first} und {second} von LENS_TABLE geben einem Objektiv verschiedene Verzeichnungen. Löschen Sie eine.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE has no k1.</source>
        <translation>Zeile {row} von LENS_TABLE hat kein k1.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE names no camera, lens or focal length that it is for.</source>
        <translation>Zeile {row} von LENS_TABLE nennt keine Kamera, kein Objektiv und keine Brennweite, für die sie gilt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE: {field} is {value}. Give one positive number for a focal length, and numbers with a decimal point for k1 and k2.</source>
        <translation>Zeile {row} von LENS_TABLE: {field} ist {value}. Geben Sie für eine Brennweite eine positive Zahl an und für k1 und k2 Zahlen mit Dezimalpunkt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch (°, + up)</source>
        <translation>Nickwinkel (°, + nach oben)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Roll (°, + right side down)</source>
        <translation>Rollwinkel (°, + rechte Seite tiefer)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Vertical field of view (°)</source>
        <translation>Vertikaler Bildwinkel (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Elevation of the camera (m)</source>
        <translation>Höhe der Kamera (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Probability that place (500 m) and heading (3°) are right</source>
        <translation>Wahrscheinlichkeit, dass Ort (500 m) und Blickrichtung (3°) richtig sind</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Agreement of the skyline with the horizon</source>
        <translation>Übereinstimmung der Horizontlinie mit dem Horizont</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Correlation of place and focal length</source>
        <translation>Korrelation von Ort und Brennweite</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Distance from the recorded position (m)</source>
        <translation>Abstand von der aufgezeichneten Position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Area (km²)</source>
        <translation>Fläche (km²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_report.py"/>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Latitude</source>
        <translation>Breite</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_report.py"/>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Longitude</source>
        <translation>Länge</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lost_crs.py"/>
        <source>QGIS has lost the definition of the layer's coordinate reference system. Set the system in the layer's properties again, or remove the layer from the project and add it again.</source>
        <translation>QGIS hat die Definition des Koordinatenbezugssystems des Layers verloren. Stellen Sie das System in den Eigenschaften des Layers neu ein, oder entfernen Sie den Layer aus dem Projekt und fügen Sie ihn wieder hinzu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/map_places.py"/>
        <source>A layer has no coordinate reference system. Assign the right one in the layer's properties.</source>
        <translation>Ein Layer hat kein Koordinatenbezugssystem. Weisen Sie in den Layereigenschaften das richtige zu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Label</source>
        <translation>Bezeichnung</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>What the pixel shows: ground, sky, void, beyond the DEM, outside the frame</source>
        <translation>Was das Pixel zeigt: ground (Gelände), sky (Himmel), void (Datenlücke), beyond (jenseits des Höhenmodells), outside (außerhalb des Bildes)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Angle of incidence (°, 0 head-on)</source>
        <translation>Einfallswinkel (°, 0 senkrecht)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Ground per pixel across the view (m)</source>
        <translation>Boden je Pixel quer zur Blickrichtung (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Error ellipse, major half axis (m)</source>
        <translation>Fehlerellipse, große Halbachse (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Error ellipse, minor half axis (m)</source>
        <translation>Fehlerellipse, kleine Halbachse (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Direction of the major axis (° from true north)</source>
        <translation>Richtung der großen Halbachse (° von geographisch Nord)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Standard deviation of the elevation (m)</source>
        <translation>Standardabweichung der Höhe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Probability that the pixel shows other ground, beyond an edge</source>
        <translation>Wahrscheinlichkeit, dass das Pixel anderes Gelände zeigt, jenseits einer Kante</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance, 5 % quantile (m)</source>
        <translation>Entfernung, 5-%-Quantil (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance, 95 % quantile (m)</source>
        <translation>Entfernung, 95-%-Quantil (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>What it shows: ground, partly ground, sky, void, beyond the DEM, outside the frame</source>
        <translation>Was es zeigt: ground (Gelände), partly ground (teils Gelände), sky (Himmel), void (Datenlücke), beyond (jenseits des Höhenmodells), outside (außerhalb des Bildes)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Share of its outline that lies on known ground</source>
        <translation>Anteil seines Umrisses, der auf bekanntem Gelände liegt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Pieces, cut where the ground behind jumps</source>
        <translation>Stücke, zerschnitten, wo das Gelände dahinter springt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Median of the error ellipses' major half axis (m)</source>
        <translation>Median der großen Halbachsen der Fehlerellipsen (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Largest of the error ellipses' major half axis (m)</source>
        <translation>Größte der großen Halbachsen der Fehlerellipsen (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Mean probability that it shows other ground, beyond an edge</source>
        <translation>Mittlere Wahrscheinlichkeit, dass es anderes Gelände zeigt, jenseits einer Kante</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Probability that the ellipse contains the true position</source>
        <translation>Wahrscheinlichkeit, dass die Ellipse die wahre Position enthält</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>The picture's size is unknown, so its pixels cannot be placed.</source>
        <translation>Die Bildgröße ist unbekannt, darum haben seine Pixel keinen Ort.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>{count} of {total} image features reach beyond the picture of {width} x {height} pixels; nothing outside it is placed. Check that they were drawn on this picture, and not on a reduced, cropped or turned copy.</source>
        <translation>{count} von {total} Bildobjekten reichen über das Bild von {width} x {height} Pixeln hinaus; außerhalb wird nichts verortet. Prüfen Sie, ob sie auf diesem Bild gezeichnet wurden und nicht auf einer verkleinerten, beschnittenen oder gedrehten Kopie.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>mean probability</source>
        <translation>mittlere Wahrscheinlichkeit</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>expected error (°)</source>
        <translation>erwarteter Fehler (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Field of view of the upright picture, across its middle. NULL: computed from the focal length in the file. Fields named k1 and k2 give the distortion of the lens (Brown, as in OpenCV).</source>
        <translation>Bildwinkel des aufrechten Bildes, durch seine Mitte. NULL: aus der Brennweite in der Datei berechnet. Felder namens k1 und k2 geben die Verzeichnung des Objektivs an (Brown, wie in OpenCV).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Absolute elevation of the camera in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Absolute Höhe der Kamera im Höhensystem des DGM. NULL: DGM plus Kamerahöhe.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Field with the error of the position (m)</source>
        <translation>Feld mit dem Fehler der Position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Standard deviation, as Position photos from a track writes it. NULL: a few metres, as GPS has in the open.</source>
        <translation>Standardabweichung, wie „Fotos anhand eines Tracks verorten“ sie schreibt. NULL: wenige Meter, wie bei GPS im offenen Gelände.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Horizontal field of view of all photos (°)</source>
        <translation>Horizontaler Bildwinkel aller Fotos (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>For photographs of one lens without a focal length in their files, across the middle of the upright picture. A value in the field takes precedence.</source>
        <translation>Für Fotos eines Objektivs ohne Brennweite in den Dateien, durch die Mitte des aufrechten Bildes. Ein Wert im Feld hat Vorrang.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Camera at the recorded altitude</source>
        <translation>Kamera auf der aufgezeichneten Höhe</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>For towers, cable cars and drones: uses the altitude in the file, if it counts from sea level, instead of the DEM plus camera height. A phone's altitude is often wrong by 10 to 50 m. The elevation in the field with the camera's elevation takes precedence.</source>
        <translation>Für Türme, Seilbahnen und Drohnen: verwendet die Höhe in der Datei, wenn sie ab dem Meeresspiegel zählt, anstelle von DGM plus Kamerahöhe. Die Höhe eines Telefons ist oft um 10 bis 50 m falsch. Die Höhe im Feld mit der Höhe der Kamera hat Vorrang.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>One point per photograph with all fields of the source, then heading, pitch, roll, field of view, their uncertainty, status and message.</source>
        <translation>Ein Punkt je Foto mit allen Feldern der Quelle, dann Blickrichtung, Nickwinkel, Rollwinkel, Bildwinkel, deren Unsicherheit, Status und Meldung.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>{count} photos: {parts}.</source>
        <translation>{count} Fotos: {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/outputs.py"/>
        <source>{path} cannot hold the fields of the photo points: {reason} Write a GeoPackage (.gpkg).</source>
        <translation>{path} kann die Felder der Fotopunkte nicht aufnehmen: {reason} Schreiben Sie ein GeoPackage (.gpkg).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/outputs.py"/>
        <source>{name} could not be written.</source>
        <translation>{name} konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/panorama_files.py"/>
        <source>panorama</source>
        <translation>Panorama</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photo points</source>
        <translation>Fotopunkte</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>One point per photograph, in any coordinate system, for example from Import geotagged photos. The point is the camera's position. If a point has no geometry, the position recorded in the photograph is used.</source>
        <translation>Ein Punkt je Foto, in jedem Koordinatensystem, zum Beispiel aus „Geotaggte Fotos importieren“. Der Punkt ist der Standort der Kamera. Wenn ein Punkt keine Geometrie hat, wird die im Foto aufgezeichnete Position verwendet.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Field with the photo's path</source>
        <translation>Feld mit dem Pfad des Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Full path of the photograph; a relative path counts from the layer's or the project's folder.</source>
        <translation>Voller Pfad des Fotos; ein relativer Pfad zählt vom Ordner des Layers oder des Projekts.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Any raster with heights in metres and a coordinate system, projected or geographic. It should extend to the mountains that are visible.</source>
        <translation>Jedes Raster mit Höhen in Metern und einem Koordinatensystem, projiziert oder geographisch. Es sollte bis zu den sichtbaren Bergen reichen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>DEM band</source>
        <translation>Kanal des DGM</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Band that holds the heights.</source>
        <translation>Kanal mit den Höhen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>as the file says</source>
        <translation>wie in der Datei angegeben</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>feet (0.3048 m)</source>
        <translation>Fuß (0,3048 m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>US survey feet</source>
        <translation>US-Vermessungsfuß</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>decimetres</source>
        <translation>Dezimeter</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>kilometres</source>
        <translation>Kilometer</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Unit of the heights</source>
        <translation>Einheit der Höhen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Unit of the heights in the elevation model. Many files in feet or decimetres do not say so; without any unit in the file, metres are assumed.</source>
        <translation>Einheit der Höhen im Höhenmodell. Viele Dateien in Fuß oder Dezimetern geben das nicht an; ohne Einheit in der Datei werden Meter angenommen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Maximum distance of the mountains on the skyline, in metres on the ground. The paper method uses at most 15 km.</source>
        <translation>Größte Entfernung der Berge auf der Horizontlinie, in Metern am Boden. Das Verfahren Aufsatz verwendet höchstens 15 km.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>robust</source>
        <translation>robust</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>paper (as published)</source>
        <translation>Aufsatz (wie veröffentlicht)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Robust: exact camera geometry, a search over all headings, and an error bar. Paper: the published correlation of skylines on a flat earth, for comparison; it does not use the compass, hints, landmarks, drawn skylines or masks.</source>
        <translation>Robust: genaue Geometrie der Kamera, eine Suche über alle Blickrichtungen und ein Fehlerbalken. Aufsatz: die veröffentlichte Korrelation der Horizontlinien auf einer flachen Erde, zum Vergleich; sie verwendet weder Kompass noch Hinweise, Landmarken, gezeichnete Horizontlinien oder Masken.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>ignore</source>
        <translation>nicht verwenden</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>use as a hint</source>
        <translation>als Hinweis verwenden</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Ignore: the heading is found without the compass. Hint: the compass heading is a prior, wide enough for the usual errors of phones; a clear skyline overrules it.</source>
        <translation>Ignorieren: Die Blickrichtung wird ohne Kompass bestimmt. Hinweis: Die Kompassrichtung ist eine Vorannahme, weit genug für die üblichen Fehler von Telefonen; eine klare Horizontlinie setzt sich darüber hinweg.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Ignore: no reading counts by itself; photos of a walk that are oriented together still compare their readings, which alone gives no heading. Hint: the compass heading is a prior, wide enough for the usual errors of phones; a clear skyline overrules it. If a camera has four or more photos, a sample of them is oriented first; if its compass often contradicts the skylines, it counts for less.</source>
        <translation>Ignorieren: Keine Angabe zählt für sich allein; Fotos einer Wanderung, die gemeinsam ausgerichtet werden, vergleichen ihre Angaben trotzdem, was allein keine Blickrichtung ergibt. Hinweis: Die Kompassrichtung ist eine Vorannahme, weit genug für die üblichen Fehler von Telefonen; eine klare Horizontlinie setzt sich darüber hinweg. Hat eine Kamera vier oder mehr Fotos, wird zuerst eine Stichprobe davon ausgerichtet; widerspricht ihr Kompass oft den Horizontlinien, zählt er weniger.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Recorded compass heading</source>
        <translation>Aufgezeichnete Kompassrichtung</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Camera height above ground (m)</source>
        <translation>Kamerahöhe über Grund (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Metres above the elevation model.</source>
        <translation>Meter über dem Geländemodell.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Distance from the camera in metres on the ground. Terrain beyond is ignored.</source>
        <translation>Entfernung von der Kamera in Metern am Boden. Gelände dahinter wird ignoriert.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Refraction coefficient</source>
        <translation>Refraktionskoeffizient</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Share of the earth's curvature that refraction compensates; 0.13 is usual. The curvature itself is always applied.</source>
        <translation>Anteil der Erdkrümmung, den die Refraktion ausgleicht; 0,13 ist üblich. Die Krümmung selbst wird immer berücksichtigt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>photo frame</source>
        <translation>Bildausschnitt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>heading wedge</source>
        <translation>Blicksektor</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>full circle</source>
        <translation>Vollkreis</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photo frame: ground inside the picture, with pitch, roll and both fields of view. Heading wedge: all ground within the horizontal field of view. Full circle: all that can be seen from the place.</source>
        <translation>Bildausschnitt: Gelände im Bild, mit Nick- und Rollwinkel und beiden Bildwinkeln. Blicksektor: alles Gelände im horizontalen Bildwinkel. Vollkreis: alles, was vom Standort zu sehen ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>confirmed</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>ambiguous</source>
        <translation>mehrdeutig</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>rejected</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photos by status</source>
        <translation>Fotos nach Status</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photos whose field status has one of these values are used; the log counts those that are left out. Photos of a layer without this field are all used.</source>
        <translation>Verwendet werden Fotos, deren Feld status einen dieser Werte hat; das Protokoll zählt die ausgelassenen. Fotos eines Layers ohne dieses Feld werden alle verwendet.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>HTML files (*.html)</source>
        <translation>HTML-Dateien (*.html)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>One self-contained HTML file with figures, numbers and advice for each photo or point. From 201 photos on, the file is an index with a map, filters and thumbnails, and the cards are pages in a folder beside it.</source>
        <translation>Eine in sich geschlossene HTML-Datei mit Abbildungen, Zahlen und Rat für jedes Foto oder jeden Punkt. Ab 201 Fotos ist die Datei ein Verzeichnis mit Karte, Filtern und Vorschaubildern, und die Fotokarten sind Seiten in einem Ordner daneben.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>without suffix</source>
        <translation>ohne Endung</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>Files that were not read as photographs: {kinds}</source>
        <translation>Dateien, die nicht als Fotos gelesen wurden: {kinds}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>No photograph (JPEG, HEIC) was found in {folder}. Choose another folder, or include its subfolders.</source>
        <translation>In {folder} wurde kein Foto (JPEG, HEIC) gefunden. Wählen Sie einen anderen Ordner oder beziehen Sie seine Unterordner ein.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/picture_files.py"/>
        <source>The point names no photo, so there is no picture to draw on.</source>
        <translation>Der Punkt nennt kein Foto; es gibt kein Bild zum Einzeichnen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/picture_files.py"/>
        <source>No installed font has all characters of {names}, so the PNG shows boxes; the SVG is right. Install a font for this script, for example a Noto Sans, and run again.</source>
        <translation>Keine installierte Schrift hat alle Zeichen von {names}, daher zeigt das PNG Kästchen; das SVG ist richtig. Installieren Sie eine Schrift für diese Schreibung, zum Beispiel eine Noto Sans, und starten Sie erneut.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Image features</source>
        <translation>Bildobjekte</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Points, lines or polygons as drawn in QGIS over the photo itself (not rotated, y negative), or in pixels of the upright picture with y counted downwards, or a table with fields x and y. A field photo names the photograph; without it the features belong to every photo.</source>
        <translation>Punkte, Linien oder Polygone, wie in QGIS über dem Foto selbst gezeichnet (nicht gedreht, y negativ), oder in Pixeln des aufrechten Bildes mit y nach unten gezählt, oder eine Tabelle mit den Feldern x und y. Ein Feld photo nennt das Foto; ohne es gehören die Objekte zu jedem Foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Image features from a labelling tool</source>
        <translation>Bildobjekte aus einem Annotationswerkzeug</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Label files (*.json *.geojson *.csv);;All files (*)</source>
        <translation>Annotationsdateien (*.json *.geojson *.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>LabelMe, COCO, VIA, GeoJSON with pixel coordinates, or CSV with photo, x, y (and feature, kind, label).</source>
        <translation>LabelMe, COCO, VIA, GeoJSON mit Pixelkoordinaten oder CSV mit photo, x, y (und feature, kind, label).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Give image features: a layer, or a file from a labelling tool.</source>
        <translation>Geben Sie Bildobjekte an: einen Layer oder eine Datei aus einem Annotationswerkzeug.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>The image features are empty: draw something on a photo first.</source>
        <translation>Die Bildobjekte sind leer: Zeichnen Sie zuerst etwas auf ein Foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>The image features have neither a geometry in pixels nor fields x and y; they have {fields}.</source>
        <translation>Die Bildobjekte haben weder eine Geometrie in Pixeln noch die Felder x und y; sie haben {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Several photos have these names, so the features were left out: {names}. Write the folders too, for example day1/IMG_0001.jpg.</source>
        <translation>Mehrere Fotos haben diese Namen, daher wurden die Objekte ausgelassen: {names}. Geben Sie auch die Ordner an, zum Beispiel day1/IMG_0001.jpg.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>No oriented photo point for: {names}</source>
        <translation>Kein orientierter Fotopunkt für: {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Its features were drawn on a file of {bytes} bytes, which is another copy of this photo. If that copy is reduced, they are in the wrong place.</source>
        <translation>Die Objekte wurden auf einer Datei von {bytes} Byte gezeichnet, einer anderen Kopie dieses Fotos. Ist diese Kopie verkleinert, liegen sie am falschen Ort.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/previews.py"/>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/reporting.py"/>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/reporting.py"/>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Field with the tolerance of that heading (°)</source>
        <translation>Feld mit der Toleranz dieser Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>How far the heading may differ from the approximate one. NULL: 20 degrees.</source>
        <translation>Wie weit die Blickrichtung von der ungefähren abweichen darf. NULL: 20 Grad.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Points on the map that are visible in photographs, with the fields photo, x and y (pixels of the upright picture; the first pixel is 0) and optionally elevation (m). One landmark is enough to determine the heading. If a field body says sun or moon, the pixel shows that, and no map point is needed: its direction follows from the time of the photograph.</source>
        <translation>Punkte der Karte, die auf Fotos zu sehen sind, mit den Feldern photo, x und y (Pixel des aufrechten Bildes; das erste Pixel ist 0) und wahlweise elevation (m). Eine Landmarke genügt, um die Blickrichtung zu bestimmen. Steht in einem Feld body sun oder moon, so zeigt das Pixel Sonne oder Mond, und ein Kartenpunkt ist nicht nötig: Die Richtung folgt aus der Aufnahmezeit.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Drawn skylines</source>
        <translation>Gezeichnete Horizontlinien</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Table with fields photo, column and row (pixels of the upright picture): the vertices of the skyline.</source>
        <translation>Tabelle mit den Feldern photo, column und row (Pixel des aufrecht stehenden Bildes): die Stützpunkte der Horizontlinie.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Folder of sky masks</source>
        <translation>Ordner mit Himmelsmasken</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Pictures named like the photographs (IMG_1.png for IMG_1.heic) in which the sky is white.</source>
        <translation>Bilder mit den Namen der Fotos (IMG_1.png für IMG_1.heic), in denen der Himmel weiß ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>{parameter}: several photos have the name {names}. Write the folders too, for example day1/IMG_0001.jpg; put sky masks into folders of the same names.</source>
        <translation>{parameter}: Mehrere Fotos haben den Namen {names}. Geben Sie auch die Ordner an, zum Beispiel day1/IMG_0001.jpg; legen Sie Himmelsmasken in Ordner mit denselben Namen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>LANDMARKS: the field body says {value}; it may say sun or moon, or be empty.</source>
        <translation>LANDMARKS: Im Feld body steht {value}; es darf sun oder moon enthalten oder leer sein.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>The table {parameter} needs the fields photo, x and y (or column and row); it has {fields}.</source>
        <translation>Die Tabelle {parameter} braucht die Felder photo, x und y (oder column und row); sie hat {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>The folder of sky masks {folder} does not exist.</source>
        <translation>Den Ordner mit Himmelsmasken {folder} gibt es nicht.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/result_figures.py"/>
        <source>PNG files with three panels: the photograph, the heading and field of view on the DEM, and the viewshed with the camera and, if the points have a timestamp, the path between the cameras.</source>
        <translation>PNG-Dateien mit drei Teilen: das Foto, die Blickrichtung und der Bildwinkel auf dem DGM und das Sichtfeld mit der Kamera und, wenn die Punkte einen Zeitstempel haben, dem Weg zwischen den Kameras.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/result_figures.py"/>
        <source>Folder for one figure per photo</source>
        <translation>Ordner für eine Abbildung je Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>{name}: {verdict}, heading {heading}°</source>
        <translation>{name}: {verdict}, Blickrichtung {heading}°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>{names} and {count} more</source>
        <translation>{names} und {count} weitere</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>Check these photos ({verdict}): {names}</source>
        <translation>Prüfen Sie diese Fotos ({verdict}): {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {seconds} s left</source>
        <translation>noch etwa {seconds} s</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {minutes} min left</source>
        <translation>noch etwa {minutes} min</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {hours} h left</source>
        <translation>noch etwa {hours} h</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Polygons in which the photographs may have been taken.</source>
        <translation>Polygone, in denen die Fotos aufgenommen worden sein können.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Extent</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Rectangle to search, if no area is given.</source>
        <translation>Zu durchsuchendes Rechteck, wenn kein Gebiet gegeben ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Radius around the recorded position (m)</source>
        <translation>Radius um die aufgezeichnete Position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Searches around the position of each photograph, if neither an area nor an extent is given.</source>
        <translation>Sucht um die Position jedes Fotos, wenn weder ein Gebiet noch ein Ausschnitt gegeben ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Paths</source>
        <translation>Wege</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Only places near these lines are searched, for example hiking trails and roads.</source>
        <translation>Nur Orte nahe diesen Linien werden durchsucht, zum Beispiel Wanderwege und Straßen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Distance from the paths (m)</source>
        <translation>Abstand von den Wegen (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Places farther from the paths are not searched. It should be at least half the spacing.</source>
        <translation>Orte, die weiter von den Wegen entfernt sind, werden nicht durchsucht. Er sollte mindestens der halbe Abstand der Orte sein.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Weights of places</source>
        <translation>Gewichte der Orte</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Raster with the relative probability that a photograph was taken at a place, for example from land cover or slope. Zero and nodata exclude a place.</source>
        <translation>Raster mit der relativen Wahrscheinlichkeit, dass an einem Ort ein Foto aufgenommen wurde, zum Beispiel aus Landbedeckung oder Hangneigung. Null und Nodata schließen einen Ort aus.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Choose where to search: an area, an extent, or a radius around the recorded positions.</source>
        <translation>Wählen Sie, wo gesucht wird: ein Gebiet, einen Ausschnitt oder einen Radius um die aufgezeichneten Positionen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The photo has no recorded position to search around. Choose an area or an extent.</source>
        <translation>Das Foto hat keine aufgezeichnete Position, um die gesucht werden kann. Wählen Sie ein Gebiet oder einen Ausschnitt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The raster of weights excludes every place of the area. Choose another.</source>
        <translation>Das Raster der Gewichte schließt jeden Ort des Gebiets aus. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>{name} has no usable feature. Choose another layer.</source>
        <translation>{name} hat kein brauchbares Objekt. Wählen Sie einen anderen Layer.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The area is empty. Choose a larger one, or a larger distance from the paths.</source>
        <translation>Das Gebiet ist leer. Wählen Sie ein größeres oder einen größeren Abstand von den Wegen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Extent of the sky view raster</source>
        <translation>Ausdehnung des Himmelssicht-Rasters</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Sky view factor of every cell of the DEM in the extent, its slope taken into account (1 = open sky).</source>
        <translation>Himmelssichtfaktor jeder DGM-Zelle in der Ausdehnung, mit ihrer Hangneigung (1 = freier Himmel).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Empty: the whole DEM. A million cells take some ten seconds.</source>
        <translation>Leer: das ganze DGM. Eine Million Zellen braucht etwa zehn Sekunden.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Search range of the sky view raster (m)</source>
        <translation>Suchweite des Himmelssicht-Rasters (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Terrain beyond is ignored; distant mountains cover little of the sky.</source>
        <translation>Gelände dahinter wird ignoriert; ferne Berge verdecken wenig vom Himmel.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Sky view factor</source>
        <translation>Himmelssichtfaktor</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>The extent of the sky view raster does not overlap the DEM. Choose another.</source>
        <translation>Die Ausdehnung des Himmelssicht-Rasters überlappt das DGM nicht. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>The search range of the sky view raster can be at most {most} m on a DEM with cells of {cell} m.</source>
        <translation>Die Suchweite des Himmelssicht-Rasters darf bei einem DGM mit Zellen von {cell} m höchstens {most} m betragen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>sky view factor</source>
        <translation>Himmelssichtfaktor</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Skylines of the photographs</source>
        <translation>Horizontlinien der Fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Table of Extract skyline (photo, column, row, confidence). Ground that would appear above its photo's skyline is hidden by something that is not in the DEM, such as trees or houses, and counts as not seen. Columns with a confidence below 0.5 exclude nothing. Requires the area photo frame.</source>
        <translation>Tabelle von Horizontlinie ausziehen (photo, column, row, confidence). Gelände, das über der Horizontlinie seines Fotos erschiene, ist von etwas verdeckt, was nicht im DGM enthalten ist, etwa Bäumen oder Häusern, und gilt als nicht gesehen. Spalten mit einer Zuverlässigkeit unter 0,5 schließen nichts aus. Erfordert den Bereich Bildausschnitt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Foreground hides ground</source>
        <translation>Vordergrund verdeckt Gelände</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Ground that would appear above the photograph's own skyline is hidden by something that is not in the DEM, such as trees or houses, and counts as not seen. Requires the area photo frame.</source>
        <translation>Gelände, das über der Horizontlinie des Fotos selbst erschiene, ist von etwas verdeckt, was nicht im DGM enthalten ist, etwa Bäumen oder Häusern, und gilt als nicht gesehen. Erfordert den Bereich Bildausschnitt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Tolerance above the skyline (°)</source>
        <translation>Toleranz über der Horizontlinie (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Ground up to this angle above the skyline still counts as seen, which allows for errors of the DEM and the heading.</source>
        <translation>Gelände bis zu diesem Winkel über der Horizontlinie gilt noch als gesehen; das berücksichtigt Fehler des DGM und der Blickrichtung.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>The table of skylines has no field {field}. Choose the table that Extract skyline has written.</source>
        <translation>Die Tabelle der Horizontlinien hat kein Feld {field}. Wählen Sie die Tabelle, die Horizontlinie ausziehen geschrieben hat.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>The table of skylines does not contain this photo, so no ground is excluded.</source>
        <translation>Die Tabelle der Horizontlinien enthält dieses Foto nicht, daher wird kein Gelände ausgeschlossen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>{count} of {total} photos get no viewshed because of their status: {parts}.</source>
        <translation>{count} von {total} Fotos erhalten wegen ihres Status kein Sichtfeld: {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Their headings are doubtful: check them in the report. To compute their viewsheds all the same, tick "Viewsheds of doubtful photos too" under Advanced (parameter DOUBTFUL).</source>
        <translation>Ihre Blickrichtungen sind zweifelhaft: Prüfen Sie sie im Bericht. Um ihre Sichtfelder trotzdem zu berechnen, wählen Sie unter Erweitert „Sichtfelder auch für zweifelhafte Fotos“ (Parameter DOUBTFUL).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>{count} of {total} photos are left out because of their status: {parts}.</source>
        <translation>{count} von {total} Fotos werden wegen ihres Status ausgelassen: {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>No photo is used, so the result is empty. {reason}</source>
        <translation>Es wird kein Foto verwendet, daher ist das Ergebnis leer. {reason}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Their headings are doubtful: check them in the report. To use them all the same, tick their statuses in "Photos by status" under Advanced (parameter STATUSES).</source>
        <translation>Ihre Blickrichtungen sind zweifelhaft: Prüfen Sie sie im Bericht. Um die Fotos trotzdem zu verwenden, wählen Sie ihren Status unter Erweitert in „Fotos nach Status“ (Parameter STATUSES).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Photos with the status failed have no heading and cannot be used.</source>
        <translation>Fotos mit dem Status „gescheitert“ haben keine Blickrichtung und können nicht verwendet werden.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/stored_style.py"/>
        <source>Style of the Skyline Viewshed plugin</source>
        <translation>Stil des Plugins Skyline Viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/stored_style.py"/>
        <source>Other fields</source>
        <translation>Weitere Felder</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <location filename="../panel/view/actions.py"/>
        <source>Summits</source>
        <translation>Gipfel</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Points with names and heights, or an OpenStreetMap extract on your disk (.osm, .osm.pbf), of which the summits are read. Empty: summits are found in the DEM by their prominence.</source>
        <translation>Punkte mit Namen und Höhen, oder ein OpenStreetMap-Auszug auf Ihrem Datenträger (.osm, .osm.pbf), aus dem die Gipfel gelesen werden. Leer: Gipfel werden im DGM nach ihrer Prominenz gesucht.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Summits without a name are left out.</source>
        <translation>Gipfel ohne Namen bleiben weg.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Text such as 4478, 4478 m or 14692 ft is read too. Heights that the DEM contradicts are not used.</source>
        <translation>Auch Text wie 4478, 4478 m oder 14692 ft wird gelesen. Höhen, denen das DGM widerspricht, werden nicht verwendet.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Minimum prominence (m)</source>
        <translation>Kleinste Schartenhöhe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Prominence of the summits that are found in the DEM.</source>
        <translation>Schartenhöhe der Gipfel, die im DGM gefunden werden.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Field with heights (m)</source>
        <translation>Feld mit Höhen (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Search radius around a published summit (m)</source>
        <translation>Suchradius um einen veröffentlichten Gipfel (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>0: use the published position.</source>
        <translation>0: die veröffentlichte Position verwenden.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM is used. The point may lie beside its summit: move it, or enlarge SNAP.</source>
        <translation>Die veröffentlichte Höhe von {height} m widerspricht dem DGM (dort {top} m), daher wird die Höhe des DGM verwendet. Vielleicht liegt der Punkt neben seinem Gipfel: Verschieben Sie ihn oder vergrößern Sie SNAP.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM is used. If it is in feet, write 'ft' after it.</source>
        <translation>Die veröffentlichte Höhe von {height} m widerspricht dem DGM (dort {top} m), daher wird die Höhe des DGM verwendet. Ist sie in Fuß, schreiben Sie 'ft' dahinter.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The layer of summits has no field {field}. Choose the field with the names.</source>
        <translation>Der Gipfellayer hat kein Feld {field}. Wählen Sie das Feld mit den Namen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Orient the photos of a walk together</source>
        <translation>Fotos einer Wanderung gemeinsam orientieren</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>The photos help one another: by features in common within 200 m (needs OpenCV), by the error of the compass, which one device shares for an hour, and by the focal length of their lens. Probability, interval and status then hold for all photos together. Accepted answers stay unless the others contradict them. A compass never gives a heading by itself. More than 300 photos are solved in blocks of 300, in the order of the layer; photos of different blocks do not help one another. The paper method ignores this.</source>
        <translation>Die Fotos helfen einander: durch gemeinsame Merkmale innerhalb von 200 m (braucht OpenCV), durch den Kompassfehler, den ein Gerät eine Stunde lang behält, und durch die Brennweite ihres Objektivs. Wahrscheinlichkeit, Intervall und Status gelten dann für alle Fotos gemeinsam. Angenommene Ergebnisse bleiben, wenn die anderen nicht widersprechen. Ein Kompass bestimmt nie allein eine Blickrichtung. Mehr als 300 Fotos werden in Blöcken von 300 gelöst, in der Reihenfolge des Layers; Fotos verschiedener Blöcke helfen einander nicht. Die Methode des Artikels beachtet dies nicht.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Photographs taken near one another or with one camera help one another, so a photograph may get a different answer in a group than alone. To orient each one by itself, turn off &lt;i&gt;Orient the photos of a walk together&lt;/i&gt; (Advanced).</source>
        <translation>Fotos von nahen Orten oder aus einer Kamera helfen einander; ein Foto kann daher in einer Gruppe ein anderes Ergebnis haben als allein. Um jedes für sich zu orientieren, schalten Sie &lt;i&gt;Fotos einer Wanderung gemeinsam orientieren&lt;/i&gt; (Erweitert) aus.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Cancelled while the photos were solved together.</source>
        <translation>Abgebrochen, während die Fotos gemeinsam gelöst wurden.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>The photos could not be solved together, so each keeps its own answer.</source>
        <translation>Die Fotos konnten nicht gemeinsam gelöst werden; jedes behält sein eigenes Ergebnis.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>{count} photos gained from their neighbours.</source>
        <translation>{count} Fotos gewannen durch ihre Nachbarn.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Photographs that help one another</source>
        <translation>Fotos, die einander helfen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Without OpenCV 4.4 or newer the photos are not compared by common features.</source>
        <translation>Ohne OpenCV 4.4 oder neuer werden die Fotos nicht anhand gemeinsamer Bildmerkmale verglichen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Track (GPX file)</source>
        <translation>Track (GPX-Datei)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>A recorded track with times. Choose either a file or a layer.</source>
        <translation>Ein aufgezeichneter Track mit Zeiten. Wählen Sie entweder eine Datei oder einen Layer.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Track (layer)</source>
        <translation>Track (Layer)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Points with a time, or lines whose M values are seconds since 1970 (UTC).</source>
        <translation>Punkte mit einer Zeit, oder Linien, deren M-Werte Sekunden seit 1970 (UTC) sind.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Field with the time</source>
        <translation>Feld mit der Zeit</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Date and time of each track point; without a time zone they count as UTC. Empty: a field named time.</source>
        <translation>Datum und Uhrzeit jedes Trackpunkts; ohne Zeitzone gelten sie als UTC. Leer: ein Feld namens time.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Choose the track: either a GPX file or a layer.</source>
        <translation>Wählen Sie den Track: entweder eine GPX-Datei oder einen Layer.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>The lines of the track have no M values with times. Choose a layer of points, or a GPX file.</source>
        <translation>Die Linien des Tracks haben keine M-Werte mit Zeiten. Wählen Sie einen Punktlayer oder eine GPX-Datei.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>The track has no field with times. Choose the field that holds them.</source>
        <translation>Der Track hat kein Feld mit Zeiten. Wählen Sie das Feld, das sie enthält.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewer.py"/>
        <source>Cancelled after {done} of {count} viewsheds.</source>
        <translation>Abgebrochen nach {done} von {count} Sichtfeldern.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Up is positive. NULL: 0.</source>
        <translation>Nach oben positiv. NULL: 0.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Only used if the photograph itself is missing.</source>
        <translation>Nur verwendet, wenn das Foto selbst fehlt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Absolute, in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Absolut, im Höhensystem des DGM. NULL: DGM plus Kamerahöhe.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the heading (°)</source>
        <translation>Unsicherheit der Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no heading_lo and heading_hi.</source>
        <translation>Standardabweichung, verwendet, wenn die Punkte kein heading_lo und heading_hi haben.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the pitch (°)</source>
        <translation>Unsicherheit des Nickwinkels (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no pitch_lo and pitch_hi.</source>
        <translation>Standardabweichung, verwendet wenn die Punkte kein pitch_lo und pitch_hi haben.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the roll (°)</source>
        <translation>Unsicherheit des Rollwinkels (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no roll_lo and roll_hi.</source>
        <translation>Standardabweichung, verwendet wenn die Punkte kein roll_lo und roll_hi haben.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the focal length (%)</source>
        <translation>Unsicherheit der Brennweite (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no hfov_lo and hfov_hi.</source>
        <translation>Standardabweichung, verwendet wenn die Punkte kein hfov_lo und hfov_hi haben.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the position (m)</source>
        <translation>Unsicherheit der Position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation of the camera's position, in east and in north. A field h_acc takes precedence.</source>
        <translation>Standardabweichung des Kamerastandorts, je in Ost- und in Nordrichtung. Ein Feld h_acc hat Vorrang.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the camera's elevation (m)</source>
        <translation>Unsicherheit der Kamerahöhe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation.</source>
        <translation>Standardabweichung.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Vertical error of the DEM (m)</source>
        <translation>Höhenfehler des DGM (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The picture's size is unknown, so a width of 4000 px is assumed.</source>
        <translation>Die Größe des Bildes ist unbekannt, daher wird eine Breite von 4000 px angenommen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The photo has no horizontal field of view between 0 and 180 degrees; orient it first.</source>
        <translation>Das Foto hat keinen horizontalen Bildwinkel zwischen 0 und 180 Grad; orientieren Sie es zuerst.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The photo has no heading; orient it first.</source>
        <translation>Das Foto hat keine Blickrichtung; orientieren Sie es zuerst.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Smallest area (m²)</source>
        <translation>Kleinste Fläche (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Smaller parts of a polygon are removed, and smaller holes are filled. 0 keeps everything.</source>
        <translation>Kleinere Teile eines Polygons werden entfernt, kleinere Löcher gefüllt. 0 behält alles.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Folder for layers per photo</source>
        <translation>Ordner für Ebenen je Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>One float GeoTIFF per photo with named bands: distance (m), elevation angle (°), height above the line of sight (m; if negative, a target must be this much higher to be visible) and, if the pose is known, column and row in the picture (px). Nodata outside the area and range.</source>
        <translation>Je Foto ein Gleitkomma-GeoTIFF mit benannten Kanälen: Entfernung (m), Höhenwinkel (°), Höhe über der Sichtlinie (m; wenn negativ, muss ein Ziel um so viel höher sein, um sichtbar zu sein) und, wenn die Ausrichtung bekannt ist, Spalte und Zeile im Bild (px). NoData außerhalb von Bereich und Reichweite.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Folder for probabilities per photo</source>
        <translation>Ordner für Wahrscheinlichkeiten je Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>One GeoTIFF per photo with the probability (0 to 1) that the picture shows a cell, given the intervals of the pose and the errors below. Requires the area photo frame, and takes about five times as long.</source>
        <translation>Je Foto ein GeoTIFF mit der Wahrscheinlichkeit (0 bis 1), dass das Bild eine Zelle zeigt, bei den Intervallen der Orientierung und den Fehlern unten. Erfordert den Bereich Bildausschnitt und dauert etwa fünfmal so lange.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of positions (m)</source>
        <translation>Fehler der Positionen (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation along each axis, for probabilities.</source>
        <translation>Standardabweichung je Achse, für Wahrscheinlichkeiten.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the DEM (m)</source>
        <translation>Fehler des DGM (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation of a cell's height relative to the terrain in front of it, for probabilities.</source>
        <translation>Standardabweichung der Höhe einer Zelle gegenüber dem Gelände davor, für Wahrscheinlichkeiten.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the pitch (°)</source>
        <translation>Fehler des Nickwinkels (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its pitch.</source>
        <translation>Standardabweichung, für Wahrscheinlichkeiten. Verwendet, wenn das Foto kein Intervall des Nickwinkels hat.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the roll (°)</source>
        <translation>Fehler des Rollwinkels (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its roll. It mainly affects ground far from the picture's centre.</source>
        <translation>Standardabweichung, für Wahrscheinlichkeiten. Verwendet, wenn das Foto kein Intervall des Rollwinkels hat. Sie wirkt sich vor allem auf Gelände weit von der Bildmitte aus.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the focal length (%)</source>
        <translation>Fehler der Brennweite (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its field of view.</source>
        <translation>Standardabweichung, für Wahrscheinlichkeiten. Verwendet, wenn das Foto kein Intervall des Bildwinkels hat.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Share of the picture that the DEM explains as ground</source>
        <translation>Anteil des Bildes, den das DGM als Gelände erklärt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Ground shown with a probability of 0.9 or more (m²)</source>
        <translation>Gelände, mit Wahrscheinlichkeit ab 0,9 gezeigt (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Ground shown with a probability of 0.5 or more (m²)</source>
        <translation>Gelände, mit Wahrscheinlichkeit ab 0,5 gezeigt (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>elevation angle</source>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>height above the line of sight</source>
        <translation>Höhe über der Sichtlinie</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>column in the photograph</source>
        <translation>Spalte im Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>row in the photograph</source>
        <translation>Zeile im Foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>No layers and probabilities: the area has more than {count} million cells. Take a shorter maximum distance.</source>
        <translation>Keine Ebenen und Wahrscheinlichkeiten: Der Bereich hat mehr als {count} Millionen Zellen. Wählen Sie eine kürzere Höchstentfernung.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>No probabilities: they need the area photo frame, with pitch and vertical field of view.</source>
        <translation>Keine Wahrscheinlichkeiten: Sie brauchen den Bereich Bildausschnitt, mit Nickwinkel und vertikalem Bildwinkel.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>probability that the photograph shows the cell</source>
        <translation>Wahrscheinlichkeit, dass das Foto die Zelle zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Farthest ground in view</source>
        <translation>Fernstes sichtbares Gelände</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>The polygon of {name} could not be built.</source>
        <translation>Das Polygon von {name} konnte nicht gebildet werden.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Ground in view (m²)</source>
        <translation>Sichtbares Gelände (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Farthest ground in view (m)</source>
        <translation>Fernstes sichtbares Gelände (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Target height above ground (m)</source>
        <translation>Zielhöhe über Grund (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Height of the target; 0 means the ground itself.</source>
        <translation>Höhe des Ziels; 0 bedeutet den Boden selbst.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Ground nearer than this does not count as seen, but it still hides the terrain behind it.</source>
        <translation>Näheres Gelände gilt nicht als gesehen, verdeckt aber dennoch das Gelände dahinter.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>The minimum distance must be smaller than the maximum distance.</source>
        <translation>Die Mindestentfernung muss kleiner sein als die größte Entfernung.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: the heading is unknown.</source>
        <translation>Kein Sichtfeld: Die Blickrichtung ist unbekannt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: the horizontal field of view is unknown.</source>
        <translation>Kein Sichtfeld: Der horizontale Bildwinkel ist unbekannt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: a field of view must lie between 0 and 180 degrees.</source>
        <translation>Kein Sichtfeld: Ein Bildwinkel muss zwischen 0 und 180 Grad liegen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Pitch or vertical field of view is unknown: the heading wedge is shown, not the photo's frame.</source>
        <translation>Nickwinkel oder vertikaler Bildwinkel ist unbekannt: Gezeigt wird der Blicksektor, nicht der Bildausschnitt.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>Processes that work on different photographs at the same time, each with up to 700 MB of memory. 0: all cores but one, as far as memory allows. 1: no further process. The results are the same. If QGIS finds no Python interpreter to start, a warning says so and one process does the work.</source>
        <translation>Prozesse, die gleichzeitig an verschiedenen Fotos arbeiten, jeder mit bis zu 700 MB Speicher. 0: alle Kerne bis auf einen, soweit der Speicher reicht. 1: kein weiterer Prozess. Die Ergebnisse sind dieselben. Findet QGIS keinen Python-Interpreter, den es starten kann, weist eine Warnung darauf hin, und ein Prozess erledigt die Arbeit.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>Worker processes</source>
        <translation>Arbeitsprozesse</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>{count} processes share the work.</source>
        <translation>{count} Prozesse teilen sich die Arbeit.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Simulate photos</source>
        <translation>Fotos simulieren</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>render,view,panorama,synthetic,photo,preview,test data</source>
        <translation>rendern,Ansicht,Panorama,synthetisch,Foto,Vorschau,Testdaten</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Realistic photographs of the terrain from points with a heading</source>
        <translation>Realistische Fotos des Geländes von Punkten mit einer Blickrichtung aus</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Renders sun, snow, haze, sky and clouds over the elevation model and writes real JPEG or HEIC files with position, compass heading and focal length, for planning photographs, for tests and for practice.</source>
        <translation>Rendert Sonne, Schnee, Dunst, Himmel und Wolken über dem Geländemodell und schreibt echte JPEG- oder HEIC-Dateien mit Position, Kompassrichtung und Brennweite, zum Planen von Fotos, für Tests und zum Üben.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Heading, pitch and roll come from fields (NULL: 0 for pitch and roll; points without a heading are skipped). The same seed gives the same pictures. The compass heading written is the exact one.</source>
        <translation>Blickrichtung, Nick- und Rollwinkel kommen aus Feldern (NULL: 0 für Nick- und Rollwinkel; Punkte ohne Blickrichtung werden übergangen). Derselbe Startwert ergibt dieselben Bilder. Die geschriebene Kompassrichtung ist die genaue.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Points with heading</source>
        <translation>Punkte mit Blickrichtung</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Width (px)</source>
        <translation>Breite (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Height (px)</source>
        <translation>Höhe (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Size of the upright picture.</source>
        <translation>Größe des aufrecht stehenden Bildes.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>HEIC needs the Python package pillow-heif.</source>
        <translation>HEIC braucht das Python-Paket pillow-heif.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Folder in which the pictures are saved.</source>
        <translation>Ordner, in dem die Bilder gespeichert werden.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>The point has no usable position or no heading.</source>
        <translation>Der Punkt hat keine brauchbare Position oder keine Blickrichtung.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>NULL: 65 degrees.</source>
        <translation>NULL: 65 Grad.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Clouds</source>
        <translation>Wolken</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>behind the ridge</source>
        <translation>hinter dem Grat</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>lid over the ridge</source>
        <translation>als Deckel über dem Grat</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>in the valley</source>
        <translation>im Tal</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Foreground</source>
        <translation>Vordergrund</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>trees</source>
        <translation>Bäume</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>people</source>
        <translation>Menschen</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Degrees.</source>
        <translation>Grad.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of the picture's width that is covered, 0 to 1.</source>
        <translation>Anteil der Bildbreite, der bedeckt ist, 0 bis 1.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Elevation. If this is empty, it is derived from the relief in view.</source>
        <translation>Höhe. Wenn leer, wird sie aus dem sichtbaren Relief abgeleitet.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>The same number gives the same picture.</source>
        <translation>Dieselbe Zahl ergibt dasselbe Bild.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Weather of the scene.</source>
        <translation>Wetter der Szene.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of clouds</source>
        <translation>Anteil der Wolken</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Objects near the camera.</source>
        <translation>Objekte nahe bei der Kamera.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of foreground</source>
        <translation>Anteil des Vordergrunds</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Azimuth of the sun (°)</source>
        <translation>Azimut der Sonne (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Elevation of the sun (°)</source>
        <translation>Höhenwinkel der Sonne (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Visual range (m)</source>
        <translation>Sichtweite (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Smaller values give more haze.</source>
        <translation>Kleinere Werte ergeben mehr Dunst.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Terrain beyond is left out.</source>
        <translation>Gelände dahinter bleibt weg.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Snow line (m)</source>
        <translation>Schneegrenze (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Tree line (m)</source>
        <translation>Waldgrenze (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Sensor noise</source>
        <translation>Sensorrauschen</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Standard deviation at mid-grey, in 8-bit steps.</source>
        <translation>Standardabweichung bei mittlerem Grau, in 8-Bit-Stufen.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Which photos show these places?</source>
        <translation>Welche Fotos zeigen diese Orte?</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>search,photo,archive,place,visible,inverse,query,resolution,ranking</source>
        <translation>Suche,Foto,Archiv,Ort,sichtbar,invers,Abfrage,Auflösung,Rangfolge</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Table of places and the photos that show them: share, pixels per metre, angle, pixel, rank</source>
        <translation>Tabelle der Orte und der Fotos, die sie zeigen: Anteil, Pixel je Meter, Winkel, Pixel, Rang</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Finds the photographs that show each point, line or area of the places layer. One row per place and photo gives the pixels per metre, the angle of incidence and the position in the picture. The best photo of each place comes first (&lt;b&gt;rank&lt;/b&gt; 1).</source>
        <translation>Findet die Fotos, die jeden Punkt, jede Linie oder Fläche des Ortslayers zeigen. Eine Zeile je Ort und Foto gibt die Pixel je Meter, den Einfallswinkel und die Position im Bild an. Das beste Foto jedes Orts kommt zuerst (&lt;b&gt;rank&lt;/b&gt; 1).</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>&lt;b&gt;quality&lt;/b&gt; = visible share x pixels per metre x cosine of the angle of incidence: the pixels per metre of ground in the worse direction. &lt;b&gt;place_id&lt;/b&gt; and &lt;b&gt;photo_id&lt;/b&gt; are the features' ids, which you can use for relations to both layers.</source>
        <translation>&lt;b&gt;quality&lt;/b&gt; = sichtbarer Anteil x Pixel je Meter x Kosinus des Einfallswinkels: die Pixel je Meter Boden in der schlechteren Richtung. &lt;b&gt;place_id&lt;/b&gt; und &lt;b&gt;photo_id&lt;/b&gt; sind die IDs der Objekte, die Sie für Beziehungen zu beiden Layern verwenden können.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Points, lines or areas, in any coordinate system.</source>
        <translation>Punkte, Linien oder Flächen, in jedem Koordinatensystem.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Copied to the table.</source>
        <translation>Wird in die Tabelle übernommen.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Height of the target above the ground, for example of a tower or a tree top.</source>
        <translation>Höhe des Ziels über dem Boden, zum Beispiel eines Turms oder einer Baumkrone.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Minimum visible share (%)</source>
        <translation>Kleinster sichtbarer Anteil (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photos that show less of a place are left out.</source>
        <translation>Fotos, die weniger von einem Ort zeigen, bleiben weg.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photos of places</source>
        <translation>Fotos von Orten</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>One row per place and photo that shows it, the best photo of each place first.</source>
        <translation>Eine Zeile je Ort und Foto, das ihn zeigt, das beste Foto jedes Ortes zuerst.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Number of rows</source>
        <translation>Anzahl der Zeilen</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Number of places that no photo shows</source>
        <translation>Anzahl der Orte, die kein Foto zeigt</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>The places layer is empty, or lies outside the region for which the DEM's CRS is valid.</source>
        <translation>Der Ortslayer ist leer oder liegt außerhalb des Bereichs, für den das KBS des DGM gültig ist.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Name of the place</source>
        <translation>Name des Orts</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Rank among the photos of the place</source>
        <translation>Rang unter den Fotos des Orts</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Visible share of the place</source>
        <translation>Sichtbarer Anteil des Orts</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Share of the place within the frame</source>
        <translation>Anteil des Orts im Bildausschnitt</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Column of its middle (px)</source>
        <translation>Spalte seiner Mitte (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Row of its middle (px)</source>
        <translation>Zeile seiner Mitte (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Azimuth from the camera (° from true north)</source>
        <translation>Azimut von der Kamera aus (° von geographisch Nord)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Elevation angle from the camera (°)</source>
        <translation>Höhenwinkel von der Kamera aus (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Pixels per metre</source>
        <translation>Pixel je Meter</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Quality: pixels per metre of ground in the worse direction</source>
        <translation>Güte: Pixel je Meter Boden in der schlechteren Richtung</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <location filename="../panel/figures.py"/>
        <location filename="../panel/model/photo_layer.py"/>
        <source>Choose a layer of oriented photo points.</source>
        <translation>Wählen Sie einen Layer orientierter Fotopunkte.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>There is no further photograph in this direction.</source>
        <translation>In dieser Richtung gibt es kein weiteres Foto.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>No photograph without a verdict follows.</source>
        <translation>Es folgt kein Foto ohne Urteil mehr.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>No viewshed yet: the photograph has no heading, or the elevation model is missing.</source>
        <translation>Noch kein Sichtfeld: Das Foto hat keine Blickrichtung, oder das Geländemodell fehlt.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>Computing the viewshed ...</source>
        <translation>Das Sichtfeld wird berechnet ...</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>Opening {photo} ...</source>
        <translation>{photo} wird geöffnet ...</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>The photograph cannot be shown.</source>
        <translation>Das Foto kann nicht angezeigt werden.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Nothing to turn yet: the picture or the elevation model is missing.</source>
        <translation>Noch nichts zu drehen: Das Bild oder das Geländemodell fehlt.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Click a place on the map that the middle of the picture shows.</source>
        <translation>Klicken Sie auf der Karte einen Ort an, den die Bildmitte zeigt.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>No landmark yet: the picture or the elevation model is missing.</source>
        <translation>Noch keine Landmarke: Das Bild oder das Geländemodell fehlt.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Now click the same point on the map.</source>
        <translation>Klicken Sie jetzt denselben Punkt auf der Karte an.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>One landmark. Set another, press Snap, or press Keep.</source>
        <translation>Eine Landmarke. Setzen Sie eine weitere, drücken Sie Einrasten oder Übernehmen.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>{count} landmarks. Set another, press Snap, or press Keep.</source>
        <translation>{count} Landmarken. Setzen Sie eine weitere, drücken Sie Einrasten oder Übernehmen.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>The landmarks contradict one another. Undo the last one, or check the pixels, the places on the map and the clock of the camera.</source>
        <translation>Die Landmarken widersprechen einander. Machen Sie die letzte rückgängig, oder prüfen Sie die Pixel, die Orte auf der Karte und die Uhr der Kamera.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>The map's coordinate system does not reach there.</source>
        <translation>Das Koordinatensystem der Karte reicht nicht bis dorthin.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Skyline drawn. Press Snap to fit the horizon to it.</source>
        <translation>Horizontlinie gezeichnet. Drücken Sie Einrasten, um den Horizont an sie anzupassen.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Masked. Press Snap to fit the horizon without it.</source>
        <translation>Maskiert. Drücken Sie Einrasten, um den Horizont ohne diesen Teil anzupassen.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>This needs a heading and an elevation model.</source>
        <translation>Dafür braucht es eine Blickrichtung und ein Geländemodell.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Drawn into the layer {layer}. Save its edits to keep it.</source>
        <translation>In den Layer {layer} gezeichnet. Speichern Sie seine Änderungen, um es zu behalten.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Folder of landmarks, skylines and masks</source>
        <translation>Ordner für Landmarken, Horizontlinien und Masken</translation>
    </message>
    <message>
        <location filename="../panel/layers.py"/>
        <source>The layer has no photographs.</source>
        <translation>Der Layer enthält keine Fotos.</translation>
    </message>
    <message>
        <location filename="../panel/layers.py"/>
        <source>The layer was removed. Choose another.</source>
        <translation>Der Layer wurde entfernt. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <location filename="../panel/model/aids.py"/>
        <source>it is not JSON. Mend it, or delete it.</source>
        <translation>sie enthält kein gültiges JSON. Reparieren oder löschen Sie sie.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>This photograph has no answer {number}.</source>
        <translation>Dieses Foto hat keine Antwort {number}.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Nothing to fit yet: the picture or the elevation model is missing.</source>
        <translation>Noch nichts anzupassen: Das Bild oder das Geländemodell fehlt.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Fitting ...</source>
        <translation>Anpassung läuft ...</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Fitted: heading {heading}°. Press Keep to write it to the layer.</source>
        <translation>Angepasst: Blickrichtung {heading}°. Drücken Sie Übernehmen, um sie in den Layer zu schreiben.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Nothing to keep yet: the photograph has no heading.</source>
        <translation>Noch nichts zu übernehmen: Das Foto hat keine Blickrichtung.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Kept in the layer's edit buffer. Save the layer's edits to make it permanent.</source>
        <translation>In den Bearbeitungspuffer des Layers übernommen. Speichern Sie die Änderungen des Layers, damit es dauerhaft wird.</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>horizon moved</source>
        <translation>Horizont verschoben</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>snapped to the skyline</source>
        <translation>an der Horizontlinie eingerastet</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>another answer chosen</source>
        <translation>andere Antwort gewählt</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>placed by landmarks</source>
        <translation>mit Landmarken bestimmt</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>landmarks given</source>
        <translation>Landmarken angegeben</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>skyline drawn</source>
        <translation>Horizontlinie gezeichnet</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>parts of the picture left out</source>
        <translation>Teile des Bildes ausgelassen</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>confirmed by hand: the answer was right</source>
        <translation>von Hand bestätigt: die Antwort war richtig</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>corrected by hand: {how}</source>
        <translation>von Hand korrigiert: {how}</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Part of the figure shows the sky or lies beyond the elevation model, so it cannot be measured.</source>
        <translation>Ein Teil der Figur zeigt den Himmel oder liegt außerhalb des Geländemodells und lässt sich deshalb nicht messen.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Area on the map {area}, outline {length}.</source>
        <translation>Fläche auf der Karte {area}, Umriss {length}.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Distance on the map {length}, height difference {rise} m.</source>
        <translation>Entfernung auf der Karte {length}, Höhenunterschied {rise} m.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Points from photos</source>
        <translation>Punkte aus Fotos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Lines from photos</source>
        <translation>Linien aus Fotos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Areas from photos</source>
        <translation>Flächen aus Fotos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>This shows no ground that the elevation model knows, so nothing was drawn.</source>
        <translation>Hier ist kein Gelände zu sehen, das das Geländemodell kennt; es wurde nichts gezeichnet.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>The layer {layer} cannot be edited.</source>
        <translation>Der Layer {layer} lässt sich nicht bearbeiten.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Draw in a photo</source>
        <translation>In einem Foto zeichnen</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Verdict of the review</source>
        <translation>Urteil der Durchsicht</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The field {field} does not take the value. Check the layer's fields.</source>
        <translation>Das Feld {field} nimmt den Wert nicht an. Prüfen Sie die Felder des Layers.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The layer {layer} is read-only. Export it as a GeoPackage, and correct the photographs there.</source>
        <translation>Der Layer {layer} ist schreibgeschützt. Exportieren Sie ihn als GeoPackage und korrigieren Sie die Fotos dort.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The layer takes no new fields ({fields}). Export it as a GeoPackage first.</source>
        <translation>Der Layer nimmt keine neuen Felder an ({fields}). Exportieren Sie ihn zuerst als GeoPackage.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Correct {photo}</source>
        <translation>{photo} korrigieren</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Review {photo}</source>
        <translation>{photo} beurteilen</translation>
    </message>
    <message>
        <location filename="../panel/model/faults.py"/>
        <source>An unexpected error occurred. Please report it and attach the log.</source>
        <translation>Ein unerwarteter Fehler ist aufgetreten. Bitte melden Sie ihn und fügen Sie das Protokoll bei.</translation>
    </message>
    <message>
        <location filename="../panel/model/photo_layer.py"/>
        <source>The layer has no field with the photographs' paths. Choose the result of Orient photos.</source>
        <translation>Der Layer hat kein Feld mit den Pfaden der Fotos. Wählen Sie das Ergebnis von Fotos orientieren.</translation>
    </message>
    <message>
        <location filename="../panel/model/session.py"/>
        <source>The photograph is no longer in the layer.</source>
        <translation>Das Foto ist nicht mehr im Layer.</translation>
    </message>
    <message>
        <location filename="../panel/model/session.py"/>
        <source>Choose an elevation model to see the horizon.</source>
        <translation>Wählen Sie ein Geländemodell, um den Horizont zu sehen.</translation>
    </message>
    <message>
        <location filename="../panel/model/solving.py"/>
        <source>The skyline contradicts the landmarks, so the horizon stays where they put it. Check the landmarks, or mask what hides the skyline.</source>
        <translation>Die Horizontlinie widerspricht den Landmarken; der Horizont bleibt, wo diese ihn festlegen. Prüfen Sie die Landmarken, oder maskieren Sie, was die Horizontlinie verdeckt.</translation>
    </message>
    <message>
        <location filename="../panel/model/solving.py"/>
        <source>The skyline does not decide more exactly here, so the horizon stays where you put it. Set a landmark, draw the skyline, or mask what hides it.</source>
        <translation>Die Horizontlinie legt es hier nicht genauer fest; der Horizont bleibt, wo Sie ihn hingelegt haben. Setzen Sie eine Landmarke, zeichnen Sie die Horizontlinie, oder maskieren Sie, was sie verdeckt.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The algorithm Directed viewshed is not there. Switch Processing on in the plugin manager.</source>
        <translation>Der Algorithmus Gerichtetes Sichtfeld fehlt. Schalten Sie Processing in der Erweiterungsverwaltung ein.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The viewshed could not be computed. The log of Processing says why.</source>
        <translation>Das Sichtfeld konnte nicht berechnet werden. Das Protokoll von Processing nennt den Grund.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>Viewshed of {photo}</source>
        <translation>Sichtfeld von {photo}</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The viewshed of {photo} is in the project.</source>
        <translation>Das Sichtfeld von {photo} ist im Projekt.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Previous</source>
        <translation>Vorheriges</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the previous photograph.</source>
        <translation>Zeigt das vorherige Foto.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Next</source>
        <translation>Nächstes</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the next photograph.</source>
        <translation>Zeigt das nächste Foto.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Next doubtful</source>
        <translation>Nächstes zweifelhaftes</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the next photograph whose status is ambiguous, rejected or failed.</source>
        <translation>Zeigt das nächste Foto mit dem Status ambiguous, rejected oder failed.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Look</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Drag to pan, wheel to zoom, double click to see the whole picture.</source>
        <translation>Ziehen verschiebt, das Rad vergrößert, ein Doppelklick zeigt das ganze Bild.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Correct</source>
        <translation>Korrigieren</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Drag the horizon. The right button or Shift turns it, the wheel changes the field of view. Arrow keys, comma, full stop, plus and minus do the same.</source>
        <translation>Ziehen Sie den Horizont. Die rechte Taste oder die Umschalttaste dreht ihn, das Rad ändert den Bildwinkel. Pfeiltasten, Komma, Punkt, Plus und Minus tun dasselbe.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a point in the picture, then the same point on the map.</source>
        <translation>Klicken Sie einen Punkt im Bild an, dann denselben Punkt auf der Karte.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the sun in the picture. Its direction follows from the time and the place of the photograph.</source>
        <translation>Klicken Sie die Sonne im Bild an. Ihre Richtung folgt aus Zeit und Ort der Aufnahme.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Moon</source>
        <translation>Mond</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the moon in the picture. Its direction follows from the time and the place of the photograph.</source>
        <translation>Klicken Sie den Mond im Bild an. Seine Richtung folgt aus Zeit und Ort der Aufnahme.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw skyline</source>
        <translation>Horizontlinie zeichnen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw the whole skyline by hand; the extracted one is ignored.</source>
        <translation>Zeichnen Sie die ganze Horizontlinie von Hand; die erkannte wird nicht verwendet.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Repair skyline</source>
        <translation>Horizontlinie ausbessern</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw over a wrong stretch of the extracted skyline.</source>
        <translation>Überzeichnen Sie ein falsches Stück der erkannten Horizontlinie.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Mask</source>
        <translation>Maskieren</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Brush over what hides the skyline: flags, clouds, people, trees.</source>
        <translation>Übermalen Sie, was die Horizontlinie verdeckt: Fahnen, Wolken, Menschen, Bäume.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Measure distance</source>
        <translation>Entfernung messen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click points in the picture: distance and height difference on the ground.</source>
        <translation>Klicken Sie Punkte im Bild an: Entfernung und Höhenunterschied im Gelände.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Measure area</source>
        <translation>Fläche messen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the corners of an area in the picture.</source>
        <translation>Klicken Sie die Ecken einer Fläche im Bild an.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw point</source>
        <translation>Punkt zeichnen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a point in the picture; it goes to the active layer if that is edited, else to a new one.</source>
        <translation>Klicken Sie einen Punkt im Bild an; er kommt in den aktiven Layer, wenn dieser bearbeitet wird, sonst in einen neuen.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw line</source>
        <translation>Linie zeichnen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a line in the picture. A double click, Enter or the right button ends it.</source>
        <translation>Klicken Sie eine Linie im Bild an. Ein Doppelklick, die Eingabetaste oder die rechte Taste beendet sie.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw area</source>
        <translation>Fläche zeichnen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click an area in the picture. A double click, Enter or the right button ends it.</source>
        <translation>Klicken Sie eine Fläche im Bild an. Ein Doppelklick, die Eingabetaste oder die rechte Taste beendet sie.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Face a place</source>
        <translation>Auf einen Ort richten</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a place on the map: the camera turns to it.</source>
        <translation>Klicken Sie einen Ort auf der Karte an: Die Kamera dreht sich dorthin.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Snap</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Fit the horizon to the picture from where it is.</source>
        <translation>Passt den Horizont von seiner jetzigen Lage aus an das Bild an.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Use alternative 2</source>
        <translation>Alternative 2 verwenden</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the second-best heading of the table, and fit from there.</source>
        <translation>Nimmt die zweitbeste Blickrichtung der Tabelle und passt von dort aus an.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Use alternative 3</source>
        <translation>Alternative 3 verwenden</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the third-best heading of the table, and fit from there.</source>
        <translation>Nimmt die drittbeste Blickrichtung der Tabelle und passt von dort aus an.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the last change back.</source>
        <translation>Nimmt die letzte Änderung zurück.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Make the change again.</source>
        <translation>Nimmt die Änderung wieder vor.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Keep</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Write the correction to the layer's edit buffer, with the status confirmed.</source>
        <translation>Schreibt die Korrektur mit dem Status confirmed in den Bearbeitungspuffer des Layers.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Compute the ground that this photograph shows, and add it as a layer.</source>
        <translation>Berechnet das Gelände, das dieses Foto zeigt, und fügt es als Layer hinzu.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Judge one photograph after the other with single keys.</source>
        <translation>Beurteilen Sie ein Foto nach dem anderen mit einzelnen Tasten.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>The answer is right.</source>
        <translation>Die Antwort ist richtig.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Reject</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>The answer is wrong.</source>
        <translation>Die Antwort ist falsch.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Doubtful</source>
        <translation>Zweifelhaft</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>It cannot be told.</source>
        <translation>Es lässt sich nicht entscheiden.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Leave it for later.</source>
        <translation>Für später lassen.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Horizon of the elevation model</source>
        <translation>Horizont des Geländemodells</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Crests below the horizon</source>
        <translation>Kämme unter dem Horizont</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Skyline in the picture</source>
        <translation>Horizontlinie im Bild</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <location filename="../core/report/card.py"/>
        <source>Alternatives</source>
        <translation>Alternativen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Azimuth and elevation angle</source>
        <translation>Azimut und Höhenwinkel</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Map layers</source>
        <translation>Kartenlayer</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Page up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Page down</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <location filename="../panel/view/canvas.py"/>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Layer of oriented photo points.</source>
        <translation>Layer orientierter Fotopunkte.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Elevation model</source>
        <translation>Geländemodell</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Show</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Choose what is drawn over the picture.</source>
        <translation>Wählen Sie, was über das Bild gezeichnet wird.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Remove the landmarks</source>
        <translation>Landmarken entfernen</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Remove what was drawn and masked</source>
        <translation>Gezeichnetes und Maskiertes entfernen</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Folder of landmarks, skylines and masks ...</source>
        <translation>Ordner für Landmarken, Horizontlinien und Masken ...</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Show the whole picture</source>
        <translation>Ganzes Bild zeigen</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Further commands for this photograph.</source>
        <translation>Weitere Befehle für dieses Foto.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Reviewed photographs</source>
        <translation>Beurteilte Fotos</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>In the picture, {distance} away.</source>
        <translation>Im Bild, {distance} entfernt.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Hidden by terrain at {distance}.</source>
        <translation>Verdeckt durch Gelände in {distance}.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>The elevation model does not know this place.</source>
        <translation>Das Geländemodell kennt diesen Ort nicht.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, straight ahead.</source>
        <translation>Außerhalb des Bildes, geradeaus.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, {angle}° to the right of its middle.</source>
        <translation>Außerhalb des Bildes, {angle}° rechts von seiner Mitte.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, {angle}° to the left of its middle.</source>
        <translation>Außerhalb des Bildes, {angle}° links von seiner Mitte.</translation>
    </message>
    <message>
        <location filename="../panel/view/strip.py"/>
        <source>Photographs of the layer</source>
        <translation>Fotos des Layers</translation>
    </message>
    <message>
        <location filename="../panel/view/strip.py"/>
        <source>Click a photograph to show it.</source>
        <translation>Klicken Sie ein Foto an, um es zu zeigen.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>No photograph. Click a point on the map with the selection tool, or a thumbnail below.</source>
        <translation>Kein Foto. Klicken Sie mit dem Auswahlwerkzeug einen Punkt auf der Karte an oder unten ein Vorschaubild.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>heading {heading}°, pitch {pitch}°, roll {roll}°, field of view {hfov}°</source>
        <translation>Blickrichtung {heading}°, Nickwinkel {pitch}°, Rollwinkel {roll}°, Bildwinkel {hfov}°</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>no heading yet: press Snap, drag the horizon, or set a landmark</source>
        <translation>noch keine Blickrichtung: Drücken Sie Einrasten, ziehen Sie den Horizont, oder setzen Sie eine Landmarke</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>the field of view is assumed</source>
        <translation>der Bildwinkel ist angenommen</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>changed, not kept</source>
        <translation>geändert, nicht übernommen</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>azimuth {azimuth}°, elevation angle {angle}°</source>
        <translation>Azimut {azimuth}°, Höhenwinkel {angle}°</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>{elevation} m high, {distance} km away (90 %: {near} to {far} km), {direction}</source>
        <translation>{elevation} m hoch, {distance} km entfernt (90 %: {near} bis {far} km), {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>Sky, {direction}</source>
        <translation>Himmel, {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>Beyond the elevation model or in a hole of it, {direction}</source>
        <translation>Außerhalb des Geländemodells oder in einer Lücke davon, {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>The sun stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep.</source>
        <translation>Die Sonne stand bei Azimut {azimuth}°, Höhenwinkel {angle}°. Drücken Sie Einrasten oder Übernehmen.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>The moon stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep.</source>
        <translation>Der Mond stand bei Azimut {azimuth}°, Höhenwinkel {angle}°. Drücken Sie Einrasten oder Übernehmen.</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>GPS altitude (m)</source>
        <translation>GPS-Höhe (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading (°)</source>
        <translation>Aufgezeichnete Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Rotation by EXIF (°)</source>
        <translation>Drehung laut EXIF (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Longitude (°)</source>
        <translation>Länge (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Latitude (°)</source>
        <translation>Breite (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Taken at (camera's local time)</source>
        <translation>Aufnahmezeit (Ortszeit der Kamera)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>35 mm equivalent focal length (mm)</source>
        <translation>Kleinbildäquivalente Brennweite (mm)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Width of the upright picture (px)</source>
        <translation>Breite des aufrecht stehenden Bildes (px)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Height of the upright picture (px)</source>
        <translation>Höhe des aufrecht stehenden Bildes (px)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading counts from (T true, M magnetic north)</source>
        <translation>Bezug der aufgezeichneten Blickrichtung (T geographisch, M magnetisch Nord)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>GPS horizontal error (m)</source>
        <translation>Horizontaler GPS-Fehler (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Correlation of skylines</source>
        <translation>Korrelation der Horizontlinien</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Correlation of the second-best heading</source>
        <translation>Korrelation der zweitbesten Blickrichtung</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Second-best heading (°)</source>
        <translation>Zweitbeste Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Third-best heading (°)</source>
        <translation>Drittbeste Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Sharpness of the correlation peak</source>
        <translation>Schärfe der Korrelationsspitze</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Heading, lower end of the 90 % interval (°)</source>
        <translation>Blickrichtung, unteres Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Heading, upper end of the 90 % interval (°)</source>
        <translation>Blickrichtung, oberes Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch, lower end of the 90 % interval (°)</source>
        <translation>Nickwinkel, unteres Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch, upper end of the 90 % interval (°)</source>
        <translation>Nickwinkel, oberes Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Roll, lower end of the 90 % interval (°)</source>
        <translation>Rollwinkel, unteres Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Roll, upper end of the 90 % interval (°)</source>
        <translation>Rollwinkel, oberes Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view, lower end of the 90 % interval (°)</source>
        <translation>Horizontaler Bildwinkel, unteres Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view, upper end of the 90 % interval (°)</source>
        <translation>Horizontaler Bildwinkel, oberes Ende des 90-%-Intervalls (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading (° from true north)</source>
        <translation>Aufgezeichnete Blickrichtung (° von geographisch Nord)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded minus found heading (°)</source>
        <translation>Aufgezeichnete minus gefundene Blickrichtung (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Grid convergence of the DEM (°)</source>
        <translation>Meridiankonvergenz des DGM (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Distance of the horizon at the heading (m)</source>
        <translation>Entfernung des Horizonts in Blickrichtung (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Camera above the DEM (m), for Visibility Analysis</source>
        <translation>Kamera über dem DGM (m), für Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Search range (m), for Visibility Analysis</source>
        <translation>Suchweite (m), für Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Left edge of view (° from grid north), for Visibility Analysis</source>
        <translation>Linker Rand der Sicht (° von Gitternord), für Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Right edge of view (° from grid north), for Visibility Analysis</source>
        <translation>Rechter Rand der Sicht (° von Gitternord), für Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/doubt.py"/>
        <source>The position is uncertain by {metres} m, which leaves the heading uncertain by more than 3 degrees. Correct the position.</source>
        <translation>Die Position ist auf {metres} m unsicher, wodurch die Blickrichtung um mehr als 3 Grad unsicher bleibt. Berichtigen Sie die Position.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The photo {path} cannot be read: {reason}</source>
        <translation>Das Foto {path} kann nicht gelesen werden: {reason}</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>{reason} Use a photo that shows a mountain skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>{reason} Verwenden Sie ein Foto, das eine Horizontlinie von Bergen zeigt, oder geben Sie eine Himmelsmaske oder eine gezeichnete Horizontlinie an.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The position {latitude}, {longitude} (latitude, longitude) lies outside the DEM. Use a DEM that covers it, or correct the photo's coordinates.</source>
        <translation>Die Position {latitude}, {longitude} (Breite, Länge) liegt außerhalb des DGM. Verwenden Sie ein DGM, das sie abdeckt, oder berichtigen Sie die Koordinaten des Fotos.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The DEM has no elevation (nodata) at {latitude}, {longitude} (latitude, longitude). Fill the void, use another DEM, or give the eye's elevation in HEIGHT_FIELD.</source>
        <translation>Das DGM hat bei {latitude}, {longitude} (Breite, Länge) keine Höhe (NoData). Füllen Sie die Lücke, verwenden Sie ein anderes DGM oder geben Sie die Höhe der Kamera in HEIGHT_FIELD an.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The file {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>Die Datei {path} kann nicht geschrieben werden: {reason}. Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The image features {path} cannot be read: {reason}</source>
        <translation>Die Bildobjekte {path} können nicht gelesen werden: {reason}</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The given elevation of the camera lies {metres} m below the DEM's surface, so the answer is not accepted. Check HEIGHT_FIELD, and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>Die angegebene Höhe der Kamera liegt {metres} m unter der Oberfläche des DGM, daher wird das Ergebnis nicht angenommen. Prüfen Sie HEIGHT_FIELD und die Einheit der Höhen des DGM (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface, more than GPS and DEM allow, so the answer is not accepted. Check the photo's position, and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>Die aufgezeichnete Höhe liegt {metres} m unter der Oberfläche des DGM, mehr als GPS und DGM zulassen, daher wird das Ergebnis nicht angenommen. Prüfen Sie die Position des Fotos und die Einheit der Höhen des DGM (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface, more than GPS and DEM allow, so the answer is not accepted. Check the photo's position and the DEM; for a drone, set USE_ALTITUDE.</source>
        <translation>Die aufgezeichnete Höhe liegt {metres} m über der Oberfläche des DGM, mehr als GPS und DGM zulassen, daher wird das Ergebnis nicht angenommen. Prüfen Sie die Position des Fotos und das DGM; schalten Sie für eine Drohne USE_ALTITUDE ein.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The skyline fits best from {metres} m above the DEM's surface, which was used.</source>
        <translation>Die Horizontlinie passt am besten von {metres} m über der Oberfläche des DGM; diese Höhe wurde verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The skyline fits best from {metres} m below the DEM's surface, which was used.</source>
        <translation>Die Horizontlinie passt am besten von {metres} m unter der Oberfläche des DGM; diese Höhe wurde verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude refers to the ellipsoid, not to sea level; the DEM was used.</source>
        <translation>Die aufgezeichnete Höhe bezieht sich auf das Ellipsoid, nicht auf den Meeresspiegel; das DGM wurde verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface and was used.</source>
        <translation>Die aufgezeichnete Höhe liegt {metres} m über der Oberfläche des DGM und wurde verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface and was used.</source>
        <translation>Die aufgezeichnete Höhe liegt {metres} m unter der Oberfläche des DGM und wurde verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface; the DEM was used.</source>
        <translation>Die aufgezeichnete Höhe liegt {metres} m über der Oberfläche des DGM; das DGM wurde verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface; the DEM was used.</source>
        <translation>Die aufgezeichnete Höhe liegt {metres} m unter der Oberfläche des DGM; das DGM wurde verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if its heights were in {unit}. Set the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>Das DGM weicht um {metres} m (Median von {count} Fotos) von den aufgezeichneten Höhen ab, als wären seine Höhen in {unit} angegeben. Stellen Sie die Einheit der Höhen des DGM ein (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if these were in feet. The program that wrote them is wrong; the DEM is used for the camera's elevation.</source>
        <translation>Das DGM weicht um {metres} m (Median von {count} Fotos) von den aufgezeichneten Höhen ab, als wären diese in Fuß angegeben. Das Programm, das sie geschrieben hat, irrt sich; für die Höhe der Kamera wird das DGM verwendet.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, nearly the same everywhere, as if one of them counted from the ellipsoid or another vertical datum. Use a DEM with heights above sea level.</source>
        <translation>Das DGM weicht um {metres} m (Median von {count} Fotos) von den aufgezeichneten Höhen ab, fast überall gleich viel, als bezöge sich eines von beiden auf das Ellipsoid oder ein anderes Höhendatum. Verwenden Sie ein DGM mit Höhen über dem Meer.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes. Check that the DEM holds heights, their unit (DEM_UNIT) and vertical datum, and the positions of the photos.</source>
        <translation>Das DGM weicht um {metres} m (Median von {count} Fotos) von den aufgezeichneten Höhen ab. Prüfen Sie, ob das DGM Höhen enthält, deren Einheit (DEM_UNIT) und Höhendatum sowie die Positionen der Fotos.</translation>
    </message>
    <message>
        <location filename="../core/base/landmark_hint.py"/>
        <source>A landmark is the sun or the moon, but the photo does not record its time with a time zone. Write the tags DateTimeOriginal and OffsetTimeOriginal, or leave this landmark out.</source>
        <translation>Eine Landmarke ist die Sonne oder der Mond, aber das Foto enthält keine Aufnahmezeit mit Zeitzone. Schreiben Sie die Tags DateTimeOriginal und OffsetTimeOriginal, oder lassen Sie diese Landmarke weg.</translation>
    </message>
    <message>
        <location filename="../core/base/landmark_hint.py"/>
        <source>A landmark is the sun or the moon, which was below the horizon at {time}. Check the landmark and the clock of the camera.</source>
        <translation>Eine Landmarke ist die Sonne oder der Mond, stand aber um {time} unter dem Horizont. Prüfen Sie die Landmarke und die Uhr der Kamera.</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>{feature} needs the Python package {package}. {hint}</source>
        <translation>{feature} braucht das Python-Paket {package}. {hint}</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>Run: {command} (or install your distribution's package)</source>
        <translation>Führen Sie aus: {command} (oder installieren Sie das Paket Ihrer Distribution)</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>In the OSGeo4W Shell run: {command}</source>
        <translation>Führen Sie in der OSGeo4W-Shell aus: {command}</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>Run: {command}</source>
        <translation>Führen Sie aus: {command}</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The photo has no GPS position. Supply it as a point in a photo point layer.</source>
        <translation>Das Foto hat keine GPS-Position. Geben Sie sie als Punkt in einem Layer mit Fotopunkten an.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The GPS position is uncertain by {km} km, too much for a horizon, so the right one is needed. Supply it as a point in a photo point layer.</source>
        <translation>Die GPS-Position ist auf {km} km unsicher, zu viel für einen Horizont, daher wird die richtige benötigt. Geben Sie sie als Punkt in einem Layer mit Fotopunkten an.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The position is uncertain by {km} km (h_acc), so the result may hold for another place than the camera's. Move the point to where the camera was, and clear h_acc.</source>
        <translation>Die Position ist auf {km} km unsicher (h_acc), das Ergebnis gilt also möglicherweise für einen anderen Ort als den der Kamera. Verschieben Sie den Punkt dorthin, wo die Kamera war, und leeren Sie h_acc.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The eye lies {metres} m below the DEM's surface, so the result is not what a camera sees. Check the camera's elevation (HEIGHT_FIELD), and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>Das Auge liegt {metres} m unter der Oberfläche des DGM, das Ergebnis ist also nicht das, was eine Kamera sieht. Prüfen Sie die Höhe der Kamera (HEIGHT_FIELD) und die Einheit der Höhen des DGM (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The eye lies {metres} m above the DEM's surface. Unless the camera flew so high, check its elevation (HEIGHT_FIELD), its height above the ground (EYE_HEIGHT), and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>Das Auge liegt {metres} m über der Oberfläche des DGM. Wenn die Kamera nicht so hoch geflogen ist, prüfen Sie ihre Höhe (HEIGHT_FIELD), ihre Höhe über dem Boden (EYE_HEIGHT) und die Einheit der Höhen des DGM (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on the picture as it is stored; they were rotated with it.</source>
        <translation>Die Objekte wurden auf dem Bild gezeichnet, wie es gespeichert ist; sie wurden mit ihm gedreht.</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on a copy of {width} x {height} pixels; they were scaled to the photo.</source>
        <translation>Die Objekte wurden auf einer Kopie von {width} x {height} Pixeln gezeichnet; sie wurden auf das Foto umgerechnet.</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on a picture of {width} x {height} pixels, which is no reduced copy of this photo of {photo_width} x {photo_height} pixels. Draw them on the photo itself.</source>
        <translation>Die Objekte wurden auf einem Bild von {width} x {height} Pixeln gezeichnet, das keine verkleinerte Kopie dieses Fotos von {photo_width} x {photo_height} Pixeln ist. Zeichnen Sie sie auf dem Foto selbst.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>In other photos of this run, the compass of this camera often contradicts the skyline, so its reading counts for less.</source>
        <translation>In anderen Fotos dieses Laufs widerspricht der Kompass dieser Kamera oft der Horizontlinie; seine Angabe zählt deshalb weniger.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>The photo is a stitched panorama, which is not the picture of one lens. Use a single photo, or give the horizontal field of view in HFOV_FIELD if the panorama is rectilinear.</source>
        <translation>Das Foto ist ein zusammengesetztes Panorama und nicht das Bild eines einzigen Objektivs. Verwenden Sie ein einzelnes Foto, oder geben Sie den horizontalen Bildwinkel in HFOV_FIELD an, wenn das Panorama geradlinig (rektilinear) ist.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>A lens with k1 = {k1} and k2 = {k2} would fold the picture before its corner. Correct k1 and k2: they are those of OpenCV, for radii in focal lengths.</source>
        <translation>Ein Objektiv mit k1 = {k1} und k2 = {k2} würde das Bild vor seiner Ecke falten. Berichtigen Sie k1 und k2: Es sind die von OpenCV, für Radien in Brennweiten.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>The drawn skyline reaches beyond the picture of {width} x {height} pixels. Draw it on this picture, not on a reduced or turned copy.</source>
        <translation>Die gezeichnete Horizontlinie reicht über das Bild von {width} x {height} Pixeln hinaus. Zeichnen Sie sie auf diesem Bild, nicht auf einer verkleinerten oder gedrehten Kopie.</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>No place within {radius} m explains the skyline well. Check the field of view and the DEM, or search a larger area with Locate photos.</source>
        <translation>Kein Ort innerhalb von {radius} m erklärt die Horizontlinie gut. Prüfen Sie den Bildwinkel und das DGM, oder durchsuchen Sie mit „Fotos lokalisieren“ ein größeres Gebiet.</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>The skyline fits from the recorded position about as well as from anywhere near it.</source>
        <translation>Die Horizontlinie passt von der aufgezeichneten Position etwa so gut wie von jedem Ort in der Nähe.</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>The skyline fits much better {distance} m away, at azimuth {azimuth} degrees; the heading differs by {turn} degrees there. Check the recorded position, which was not changed.</source>
        <translation>Die Horizontlinie passt {distance} m entfernt viel besser, im Azimut {azimuth} Grad; die Blickrichtung weicht dort um {turn} Grad ab. Prüfen Sie die aufgezeichnete Position; sie wurde nicht geändert.</translation>
    </message>
    <message>
        <location filename="../core/figures/annotate.py"/>
        <source>annotated photograph</source>
        <translation>beschriftetes Foto</translation>
    </message>
    <message>
        <location filename="../core/figures/fonts.py"/>
        <source>Text in pictures needs a TrueType font, but none of DejaVu Sans, Arial, Liberation Sans or Helvetica is installed. Install one of them, for example with the package fonts-dejavu-core, or install a newer Pillow.</source>
        <translation>Text in Bildern braucht eine TrueType-Schrift, aber weder DejaVu Sans noch Arial, Liberation Sans oder Helvetica ist installiert. Installieren Sie eine davon, zum Beispiel mit dem Paket fonts-dejavu-core, oder installieren Sie ein neueres Pillow.</translation>
    </message>
    <message>
        <location filename="../core/figures/fonts.py"/>
        <location filename="../core/figures/raster.py"/>
        <source>Drawing and writing pictures</source>
        <translation>Das Zeichnen und Schreiben von Bildern</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>view</source>
        <translation>Blick</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>heading</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>viewshed</source>
        <translation>Sichtfeld</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <location filename="../core/figures/overlay.py"/>
        <location filename="../core/report/overview.py"/>
        <source>extracted skyline</source>
        <translation>erkannte Horizontlinie</translation>
    </message>
    <message>
        <location filename="../core/figures/overlay.py"/>
        <source>DEM horizon at {heading}</source>
        <translation>DGM-Horizont bei {heading}</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <location filename="../core/figures/score.py"/>
        <source>The DEM has no horizon here.</source>
        <translation>Das DGM hat hier keinen Horizont.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Horizon of the DEM over all azimuths</source>
        <translation>Horizont des DGM über alle Azimute</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Image skyline against DEM horizon</source>
        <translation>Horizontlinie des Bildes gegen Horizont des DGM</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>No column of the picture was compared with the DEM.</source>
        <translation>Keine Spalte des Bildes wurde mit dem DGM verglichen.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Skyline above DEM [px]</source>
        <translation>Horizontlinie über DGM [px]</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Residuals along the columns: {words}.</source>
        <translation>Abweichungen entlang der Spalten: {words}.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>no column compared</source>
        <translation>keine Spalte verglichen</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>median {value}</source>
        <translation>Median {value}</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>{share} % of the height</source>
        <translation>{share} % der Höhe</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>{share} % of columns</source>
        <translation>{share} % der Spalten</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Elevation angle</source>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Distance</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>cut by the DEM's edge</source>
        <translation>am Rand des DGM abgeschnitten</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>void</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>The horizon is highest at azimuth {azimuth}: its elevation angle there is {angle} degrees and its distance {distance}. The median elevation angle is {median} degrees. In {share} % of the directions the DEM ends before higher terrain can be ruled out.</source>
        <translation>Der Horizont ist beim Azimut {azimuth} am höchsten: Sein Höhenwinkel beträgt dort {angle} Grad, seine Entfernung {distance}. Der Median der Höhenwinkel beträgt {median} Grad. In {share} % der Richtungen endet das DGM, bevor höheres Gelände ausgeschlossen ist.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Score over all headings</source>
        <translation>Wertung über alle Blickrichtungen</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>No heading was scored.</source>
        <translation>Keine Blickrichtung wurde bewertet.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>compass</source>
        <translation>Kompass</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>{score} over all headings</source>
        <translation>{score} über alle Blickrichtungen</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Score by direction, north up</source>
        <translation>Wertung nach Richtung, Norden oben</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The probability is highest at azimuth {heading}: {share} %.</source>
        <translation>Die Wahrscheinlichkeit ist am größten beim Azimut {heading}: {share} %.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Probability of a unique answer by direction, north up</source>
        <translation>Wahrscheinlichkeit einer eindeutigen Antwort nach Richtung, Norden oben</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>No heading was found.</source>
        <translation>Keine Blickrichtung wurde gefunden.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The best heading is {heading} from true north.</source>
        <translation>Die beste Blickrichtung ist {heading} von geographisch Nord.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Alternatives are at {headings}.</source>
        <translation>Alternativen liegen bei {headings}.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The compass recorded {heading}.</source>
        <translation>Der Kompass hat {heading} aufgezeichnet.</translation>
    </message>
    <message>
        <location filename="../core/figures/stations.py"/>
        <source>{count} photographs within {extent} kilometres.</source>
        <translation>{count} Fotos innerhalb von {extent} Kilometern.</translation>
    </message>
    <message>
        <location filename="../core/figures/stations.py"/>
        <location filename="../core/report/collection.py"/>
        <location filename="../core/report/report.py"/>
        <source>Camera positions and headings</source>
        <translation>Standorte und Blickrichtungen der Kamera</translation>
    </message>
    <message>
        <location filename="../core/figures/text.py"/>
        <source>N NNE NE ENE E ESE SE SSE S SSW SW WSW W WNW NW NNW</source>
        <translation>N NNO NO ONO O OSO SO SSO S SSW SW WSW W WNW NW NNW</translation>
    </message>
    <message>
        <location filename="../core/io/crs.py"/>
        <source>The coordinate reference system {crs} is not recognised. Assign a valid one.</source>
        <translation>Das Koordinatenbezugssystem {crs} ist unbekannt. Weisen Sie ein gültiges zu.</translation>
    </message>
    <message>
        <location filename="../core/io/crs.py"/>
        <source>No transformation from {source} to {target} is available. Use a DEM in a common coordinate system.</source>
        <translation>Es gibt keine Transformation von {source} nach {target}. Verwenden Sie ein DGM in einem gebräuchlichen Koordinatensystem.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} is a picture with a colour palette, not a raster of heights. Choose the elevation raster itself.</source>
        <translation>Das DGM {path} ist ein Bild mit einer Farbpalette und kein Raster mit Höhen. Wählen Sie das Höhenraster selbst.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} has only 8 bits per cell, like a hillshade or another picture of the terrain. Choose the elevation raster itself; if these are heights, set their unit (DEM_UNIT).</source>
        <translation>Das DGM {path} hat nur 8 Bit je Zelle wie eine Schummerung oder ein anderes Bild des Geländes. Wählen Sie das Höhenraster selbst; wenn es sich um Höhen handelt, stellen Sie deren Einheit ein (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} holds heights encoded as colours (terrain-RGB, {name}). Decode them first with the raster calculator: {formula}, where R, G and B are the bands.</source>
        <translation>Das DGM {path} enthält als Farben kodierte Höhen (Terrain-RGB, {name}). Dekodieren Sie sie zuerst mit dem Rasterrechner: {formula}; R, G und B sind die Kanäle.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} is a colour picture (red, green, blue), not a raster of heights. Choose the elevation raster itself.</source>
        <translation>Das DGM {path} ist ein Farbbild (Rot, Grün, Blau) und kein Raster mit Höhen. Wählen Sie das Höhenraster selbst.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>Band {band} of the DEM {path} has no valid cell. Choose another DEM.</source>
        <translation>Kanal {band} des DGM {path} hat keine gültige Zelle. Wählen Sie ein anderes DGM.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} has values up to {highest}, which are no heights in metres: perhaps they are decimetres or centimetres. Set their unit (DEM_UNIT).</source>
        <translation>Das DGM {path} hat Werte bis {highest}, die keine Höhen in Metern sind: vielleicht sind es Dezimeter oder Zentimeter. Stellen Sie die Einheit ein (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The values of the DEM {path} lie between {low} and {high} and change from cell to cell like those of a hillshade, slope or aspect map, not like heights. Choose the elevation raster itself; if these are heights, set their unit (DEM_UNIT).</source>
        <translation>Die Werte des DGM {path} liegen zwischen {low} und {high} und ändern sich von Zelle zu Zelle wie bei einer Schummerung, Neigungs- oder Expositionskarte, nicht wie Höhen. Wählen Sie das Höhenraster selbst; wenn es sich um Höhen handelt, stellen Sie deren Einheit ein (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is larger than 200 MB. Split it by photograph.</source>
        <translation>Die Datei ist größer als 200 MB. Teilen Sie sie nach Fotos auf.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not UTF-8 text. Export it as JSON or CSV.</source>
        <translation>Die Datei ist kein Text in UTF-8. Exportieren Sie sie als JSON oder CSV.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <location filename="../core/io/formats.py"/>
        <source>it cannot be opened ({reason}). Check the path and the permissions.</source>
        <translation>Die Datei kann nicht geöffnet werden ({reason}). Prüfen Sie den Pfad und die Zugriffsrechte.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not valid JSON. Export it again.</source>
        <translation>Die Datei ist kein gültiges JSON. Exportieren Sie sie neu.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not in the format of LabelMe, COCO, VIA or GeoJSON. Export it in one of these formats, or as CSV with the columns photo, x and y.</source>
        <translation>Die Datei hat keines der Formate LabelMe, COCO, VIA oder GeoJSON. Exportieren Sie sie in einem dieser Formate oder als CSV mit den Spalten photo, x und y.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>an entry is incomplete ({reason}). Export the file again.</source>
        <translation>Ein Eintrag ist unvollständig ({reason}). Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it has no columns x and y (pixels). Name its columns photo, x and y.</source>
        <translation>Es fehlen die Spalten x und y (Pixel). Nennen Sie die Spalten photo, x und y.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>line {number} has no numbers for x and y. Correct that line.</source>
        <translation>Zeile {number} hat keine Zahlen für x und y. Berichtigen Sie diese Zeile.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>line {number} is incomplete ({reason}). Correct that line.</source>
        <translation>Zeile {number} ist unvollständig ({reason}). Berichtigen Sie diese Zeile.</translation>
    </message>
    <message>
        <location filename="../core/io/folder.py"/>
        <source>The folder {folder} cannot be listed: {reason}. Check the path.</source>
        <translation>Der Inhalt des Ordners {folder} ist nicht zu lesen: {reason}. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>the file is empty. Copy it again from its source.</source>
        <translation>Die Datei ist leer. Kopieren Sie sie neu von der Quelle.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it ends too early or its directory is damaged. Copy it again from its source.</source>
        <translation>Die Datei endet zu früh, oder ihr Verzeichnis ist beschädigt. Kopieren Sie sie neu von der Quelle.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>its content is not a JPEG, HEIC, PNG, TIFF or WebP picture. Export it as JPEG.</source>
        <translation>Der Inhalt ist kein Bild in JPEG, HEIC, PNG, TIFF oder WebP. Exportieren Sie es als JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it has no pixels. Copy it again from its source.</source>
        <translation>Die Datei hat keine Pixel. Kopieren Sie sie neu von der Quelle.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>its {width} x {height} pixels are more than {limit} megapixels. Reduce its size first.</source>
        <translation>{width} x {height} Pixel sind mehr als {limit} Megapixel. Verkleinern Sie das Bild zuerst.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it is a folder or a device, not a file. Check the path.</source>
        <translation>Es ist ein Ordner oder ein Gerät, keine Datei. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>there is no such file. Check the path.</source>
        <translation>Die Datei gibt es nicht. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} has {count} band(s), but no band {band}. Choose another.</source>
        <translation>Das DGM {path} hat {count} Kanäle, aber keinen Kanal {band}. Wählen Sie einen anderen Kanal.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>Band {band} of {path} contains complex numbers. Choose an elevation raster.</source>
        <translation>Kanal {band} von {path} enthält komplexe Zahlen. Wählen Sie ein Höhenraster.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} has no geographic or projected coordinate reference system. Assign the right one (gdal_edit -a_srs).</source>
        <translation>Das DGM {path} hat kein geographisches oder projiziertes Koordinatenbezugssystem. Weisen Sie das richtige zu (gdal_edit -a_srs).</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The coordinate reference system of the DEM {path} cannot be used. {reason}</source>
        <translation>Das Koordinatenbezugssystem des DGM {path} ist nicht verwendbar. {reason}</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} is not georeferenced. Warp it to a CRS first (gdalwarp).</source>
        <translation>Das DGM {path} ist nicht georeferenziert. Bringen Sie es zuerst in ein KBS (gdalwarp).</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} is rotated relative to its CRS. Warp it to a north-up grid first (gdalwarp).</source>
        <translation>Das DGM {path} ist gegen sein KBS gedreht. Transformieren Sie es zuerst auf ein nach Norden ausgerichtetes Gitter (gdalwarp).</translation>
    </message>
    <message>
        <location filename="../core/io/gpx.py"/>
        <source>The track {path} has no points. Choose a GPX file with a recorded track.</source>
        <translation>Der Track {path} hat keine Punkte. Wählen Sie eine GPX-Datei mit einem aufgezeichneten Track.</translation>
    </message>
    <message>
        <location filename="../core/io/height_unit.py"/>
        <source>The values of the DEM are in {unit}, which is not a unit of height that is known here. Choose an elevation raster, or set the unit of its heights (DEM_UNIT).</source>
        <translation>Die Werte des DGM sind in {unit} angegeben, was hier nicht als Einheit von Höhen bekannt ist. Wählen Sie ein Höhenraster, oder stellen Sie die Einheit seiner Höhen ein (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/height_unit.py"/>
        <source>The unit of heights {unit} is not known. Give metres, feet, us-ft, dm, cm, km or a number of metres.</source>
        <translation>Die Höheneinheit {unit} ist nicht bekannt. Geben Sie metres, feet, us-ft, dm, cm, km oder eine Anzahl Meter an.</translation>
    </message>
    <message>
        <location filename="../core/io/label_tools.py"/>
        <source>Shapes without an outline that can be read were left out: {kinds}.</source>
        <translation>Formen ohne lesbaren Umriss wurden ausgelassen: {kinds}.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The 35 mm equivalent was derived from the focal length and the focal plane resolution.</source>
        <translation>Die kleinbildäquivalente Brennweite wurde aus der Brennweite und der Auflösung der Bildebene abgeleitet.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The recorded 35 mm equivalent of {recorded} mm contradicts the recorded focal length and sensor, from which {derived} mm follows. If you know the horizontal field of view, give it in HFOV_FIELD.</source>
        <translation>Die aufgezeichnete kleinbildäquivalente Brennweite von {recorded} mm widerspricht der aufgezeichneten Brennweite und dem Sensor, aus denen {derived} mm folgen. Wenn Sie den horizontalen Bildwinkel kennen, geben Sie ihn in HFOV_FIELD an.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The picture is cropped: a 35 mm equivalent of {used} mm was used instead of {recorded} mm. If you know the horizontal field of view, give it in HFOV_FIELD.</source>
        <translation>Das Bild ist beschnitten: Statt {recorded} mm wurde eine kleinbildäquivalente Brennweite von {used} mm verwendet. Wenn Sie den horizontalen Bildwinkel kennen, geben Sie ihn in HFOV_FIELD an.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>No lens has the recorded 35 mm equivalent of {recorded} mm; it was ignored.</source>
        <translation>Kein Objektiv hat die aufgezeichnete kleinbildäquivalente Brennweite von {recorded} mm; sie wurde nicht beachtet.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The recorded 35 mm equivalent leaves out the digital zoom: {used} mm was used instead of {recorded} mm.</source>
        <translation>Die aufgezeichnete kleinbildäquivalente Brennweite enthält den Digitalzoom nicht: Statt {recorded} mm wurden {used} mm verwendet.</translation>
    </message>
    <message>
        <location filename="../core/io/local_copy.py"/>
        <source>the file cannot be opened</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates are not numbers (no GPS fix) and were ignored.</source>
        <translation>Die aufgezeichneten Koordinaten sind keine Zahlen (kein GPS-Empfang) und wurden nicht verwendet.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates lie outside the range of latitude and longitude and were ignored.</source>
        <translation>Die aufgezeichneten Koordinaten liegen außerhalb des Wertebereichs von Breite und Länge und wurden nicht beachtet.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates are 0, 0 (no GPS fix) and were ignored.</source>
        <translation>Die aufgezeichneten Koordinaten sind 0, 0 (kein GPS-Empfang) und wurden nicht verwendet.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The hemisphere is not recorded; north and east were assumed where it is missing.</source>
        <translation>Die Halbkugel ist nicht aufgezeichnet; wo sie fehlt, wurden Nord und Ost angenommen.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The GPS had no fix when the photo was taken, so the position may be that of another place.</source>
        <translation>Das GPS hatte bei der Aufnahme keinen Empfang, daher kann die Position die eines anderen Ortes sein.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The GPS position is imprecise (DOP {dop}): an error of {metres} m was assumed.</source>
        <translation>Die GPS-Position ist ungenau (DOP {dop}): Es wurde ein Fehler von {metres} m angenommen.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The picture is a panorama of {angle} degrees, not that of one lens; its field of view is unknown.</source>
        <translation>Das Bild ist ein Panorama von {angle} Grad und nicht das eines einzigen Objektivs; sein Bildwinkel ist unbekannt.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The picture is a panorama, not that of one lens; its field of view is unknown.</source>
        <translation>Das Bild ist ein Panorama und nicht das eines einzigen Objektivs; sein Bildwinkel ist unbekannt.</translation>
    </message>
    <message>
        <location filename="../core/io/osm_summits.py"/>
        <source>The OpenStreetMap extract {path} cannot be read: {reason}. Download it again.</source>
        <translation>Der OpenStreetMap-Auszug {path} kann nicht gelesen werden: {reason}. Laden Sie ihn erneut herunter.</translation>
    </message>
    <message>
        <location filename="../core/io/osm_summits.py"/>
        <source>it has another format</source>
        <translation>er hat ein anderes Format</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>it is damaged or incomplete. Copy it again from its source.</source>
        <translation>Die Datei ist beschädigt oder unvollständig. Kopieren Sie sie neu von der Quelle.</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>it is too large for this computer's memory. Reduce its size.</source>
        <translation>Das Bild ist zu groß für den Speicher dieses Rechners. Verkleinern Sie es.</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>HEIC needs the Python package pillow-heif. {hint}, or export it as JPEG.</source>
        <translation>HEIC braucht das Python-Paket pillow-heif. {hint}, oder exportieren Sie das Foto als JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} does not exist. Check the path.</source>
        <translation>Das DGM {path} gibt es nicht. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} is not a raster that GDAL can read. Choose an elevation raster.</source>
        <translation>Das DGM {path} ist kein Raster, das GDAL lesen kann. Wählen Sie ein Höhenraster.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} is damaged ({reason}). Copy it again.</source>
        <translation>Das DGM {path} ist beschädigt ({reason}). Kopieren Sie es neu.</translation>
    </message>
    <message>
        <location filename="../core/io/report_file.py"/>
        <location filename="../core/io/whole_file.py"/>
        <location filename="../core/io/write_raster.py"/>
        <source>the folder {folder} does not exist</source>
        <translation>den Ordner {folder} gibt es nicht</translation>
    </message>
    <message>
        <location filename="../core/io/report_file.py"/>
        <source>The report {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>Der Bericht {path} kann nicht geschrieben werden: {reason}. Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <location filename="../core/io/tiff_pages.py"/>
        <source>it is a raw file of a camera, which must be exported as JPEG first.</source>
        <translation>Die Datei ist eine Rohdatei einer Kamera, die zuerst als JPEG exportiert werden muss.</translation>
    </message>
    <message>
        <location filename="../core/io/tiff_pages.py"/>
        <source>its first page of {width} x {height} pixels is a thumbnail of a larger picture. Export that as JPEG.</source>
        <translation>Ihre erste Seite mit {width} x {height} Pixeln ist ein Vorschaubild eines größeren Bildes. Exportieren Sie dieses als JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>The photo {path} cannot be written: its name must end in .jpg or .heic.</source>
        <translation>Das Foto {path} kann nicht geschrieben werden: Sein Name muss auf .jpg oder .heic enden.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>Writing HEIC photographs</source>
        <translation>Das Schreiben von HEIC-Fotos</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>The photo {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>Das Foto {path} kann nicht geschrieben werden: {reason}. Wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>Writing photographs</source>
        <translation>Das Schreiben von Fotos</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>cannot be created</source>
        <translation>sie kann nicht angelegt werden</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>the folder {folder} is read-only</source>
        <translation>der Ordner {folder} ist schreibgeschützt</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>the disk may be full</source>
        <translation>der Datenträger ist vielleicht voll</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The photos taken nearby decide the heading: no other heading fits all of them.</source>
        <translation>Die in der Nähe aufgenommenen Fotos entscheiden die Blickrichtung: Keine andere passt zu allen.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>Photos taken nearby contradict this heading. Compare the overlays, or give an approximate heading or a landmark.</source>
        <translation>In der Nähe aufgenommene Fotos widersprechen dieser Blickrichtung. Vergleichen Sie die Überlagerungen, oder geben Sie eine ungefähre Blickrichtung oder eine Landmarke an.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The photos taken nearby suggest this heading but do not decide it. Check the overlay, or give an approximate heading or a landmark.</source>
        <translation>Die in der Nähe aufgenommenen Fotos sprechen für diese Blickrichtung, entscheiden sie aber nicht. Prüfen Sie die Überlagerung, oder geben Sie eine ungefähre Blickrichtung oder eine Landmarke an.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>Features that it shares with {photos} helped to find the heading.</source>
        <translation>Gemeinsame Bildmerkmale mit {photos} halfen, die Blickrichtung zu finden.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The error of the compass that it shares with {count} photos of the same hour (such as {photo}) helped to find the heading.</source>
        <translation>Der Kompassfehler, den es mit {count} Fotos derselben Stunde teilt (etwa {photo}), half, die Blickrichtung zu finden.</translation>
    </message>
    <message>
        <location filename="../core/locate/build.py"/>
        <source>The DEM has no heights in the area. Choose another area, or a DEM without voids there.</source>
        <translation>Das DGM hat im Gebiet keine Höhen. Wählen Sie ein anderes Gebiet oder ein DGM, das dort keine Lücken hat.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>From this place, the DEM horizon matches the skyline in {share} % of the columns; no place elsewhere in the area scores close.</source>
        <translation>Von diesem Ort stimmt der DGM-Horizont in {share} % der Spalten mit der Horizontlinie überein; kein Ort anderswo im Gebiet kommt nahe heran.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>No place in the area fits the skyline clearly. The photo was probably not taken in this area, or clouds, trees or a narrow view hide what would decide it. Choose another area, or give a sky mask or the field of view.</source>
        <translation>Kein Ort im Gebiet passt klar zur Horizontlinie. Das Foto wurde wahrscheinlich nicht in diesem Gebiet aufgenommen, oder Wolken, Bäume oder ein enger Blick verbergen, was entscheiden würde. Wählen Sie ein anderes Gebiet, oder geben Sie eine Himmelsmaske oder den Bildwinkel an.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>This place fits best, but others in the area fit nearly as well, or the fit is weak. Compare the candidates, or choose a smaller area.</source>
        <translation>Dieser Ort passt am besten, aber andere im Gebiet passen fast so gut, oder die Übereinstimmung ist schwach. Vergleichen Sie die Kandidaten, oder wählen Sie ein kleineres Gebiet.</translation>
    </message>
    <message>
        <location filename="../core/locate/places.py"/>
        <source>The area needs an index of {needed} MB, and {limit} MB are allowed. Choose an area of at most {km2} km2, a wider spacing of the places, or a folder for the index, which then stays on disk.</source>
        <translation>Das Gebiet braucht einen Index von {needed} MB, und {limit} MB sind erlaubt. Wählen Sie ein Gebiet von höchstens {km2} km2, einen größeren Abstand der Orte oder einen Ordner für den Index, der dann auf der Platte bleibt.</translation>
    </message>
    <message>
        <location filename="../core/locate/places.py"/>
        <source>No part of the area lies inside the DEM. Choose an area that the DEM covers, or another DEM.</source>
        <translation>Kein Teil des Gebiets liegt im DGM. Wählen Sie ein Gebiet, das das DGM abdeckt, oder ein anderes DGM.</translation>
    </message>
    <message>
        <location filename="../core/locating.py"/>
        <source>Hardly any column of the picture shows a boundary between sky and terrain.</source>
        <translation>Kaum eine Spalte des Bildes zeigt eine Grenze zwischen Himmel und Gelände.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>At the landmark's heading the DEM horizon does not follow the skyline that was found in the picture. Check the landmark and the overlay, or give a second landmark, a sky mask or a drawn skyline.</source>
        <translation>Bei der Blickrichtung der Landmarke folgt der Horizont des Höhenmodells nicht der Horizontlinie, die im Bild gefunden wurde. Prüfen Sie die Landmarke und die Überlagerung, oder geben Sie eine zweite Landmarke, eine Himmelsmaske oder eine gezeichnete Horizontlinie an.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies outside the picture of {width} x {height} pixels and was not used. Check that its pixel belongs to this picture, and not to a reduced or turned copy.</source>
        <translation>Landmarke {number} liegt außerhalb des Bildes von {width} x {height} Pixeln und wurde nicht verwendet. Prüfen Sie, ob ihr Pixel zu diesem Bild gehört und nicht zu einer verkleinerten oder gedrehten Kopie.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} contradicts the picture, in which the skyline alone decides the heading: its map point lies {count} degrees in azimuth from its pixel. It was not used. Check the pixel and the map point.</source>
        <translation>Landmarke {number} widerspricht dem Bild, in dem schon die Horizontlinie allein die Blickrichtung bestimmt: Ihr Kartenpunkt liegt im Azimut {count} Grad neben ihrem Pixel. Sie wurde nicht verwendet. Prüfen Sie das Pixel und den Kartenpunkt.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies {count} pixels from its predicted position.</source>
        <translation>Landmarke {number} liegt {count} Pixel von ihrer vorausberechneten Lage entfernt.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies outside the view, {count} degrees in azimuth from the heading. Check the landmark and the position.</source>
        <translation>Landmarke {number} liegt außerhalb des Blickfelds, ihr Azimut weicht um {count} Grad von der Blickrichtung ab. Prüfen Sie die Landmarke und die Position.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The skyline does not decide the heading, so the approximate heading is given back. Check the overlay, or give a landmark, a drawn skyline or a sky mask.</source>
        <translation>Die Horizontlinie entscheidet nicht über die Blickrichtung, deshalb wird die ungefähre Richtung zurückgegeben. Prüfen Sie die Überlagerung oder geben Sie eine Landmarke, eine gezeichnete Horizontlinie oder eine Himmelsmaske an.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The mirror image of the photo fits the DEM better than the photo itself. If it was flipped (a slide scanned from the wrong side), flip it back and run again; else check the overlay.</source>
        <translation>Das Spiegelbild des Fotos passt besser zum DGM als das Foto selbst. Wenn es seitenverkehrt ist (ein von der falschen Seite gescanntes Dia), spiegeln Sie es zurück und starten Sie neu; andernfalls prüfen Sie die Überlagerung.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>According to the DEM, the most distinct line in the picture is a nearby crest; the fainter line behind it was used as the skyline.</source>
        <translation>Nach dem DGM ist die deutlichste Linie im Bild ein naher Grat; als Horizontlinie wurde die schwächere Linie dahinter verwendet.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>Hardly any column of the picture shows a boundary between sky and terrain. Use a photo with a skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>Kaum eine Spalte des Bildes zeigt eine Grenze zwischen Himmel und Gelände. Verwenden Sie ein Foto mit einer Horizontlinie, oder geben Sie eine Himmelsmaske oder eine gezeichnete Horizontlinie an.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The DEM has no terrain around this position. Use a DEM that reaches farther.</source>
        <translation>Das DGM hat um diese Position kein Gelände. Verwenden Sie ein DGM, das weiter reicht.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>In {share} % of the frame the DEM ends or has voids before higher terrain can be ruled out. Use a larger DEM to make the heading more certain.</source>
        <translation>In {share} % des Bildes endet das DGM oder hat Lücken, bevor höheres Gelände ausgeschlossen ist. Verwenden Sie ein größeres DGM, damit die Blickrichtung sicherer wird.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The photo's compass says {heading} degrees and took no part. If you trust it, use it as a hint (COMPASS).</source>
        <translation>Der Kompass des Fotos zeigt {heading} Grad und wurde nicht berücksichtigt. Wenn Sie ihm vertrauen, verwenden Sie ihn als Hinweis (COMPASS).</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The horizon is almost straight here, so it fits many headings. Give an approximate heading or a landmark.</source>
        <translation>Der Horizont ist hier fast gerade und passt zu vielen Blickrichtungen. Geben Sie eine ungefähre Blickrichtung oder eine Landmarke an.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The DEM horizon matches the skyline in {share} % of the columns; no other heading scores close.</source>
        <translation>Der Horizont des DGM stimmt in {share} % der Spalten mit der Horizontlinie überein; keine andere Blickrichtung erreicht eine ähnliche Wertung.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>No heading fits the skyline. Check the position and the field of view, or give a sky mask, a drawn skyline, a landmark or an approximate heading.</source>
        <translation>Keine Blickrichtung passt zur Horizontlinie. Prüfen Sie Position und Bildwinkel, oder geben Sie eine Himmelsmaske, eine gezeichnete Horizontlinie, eine Landmarke oder eine ungefähre Blickrichtung an.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>A heading of {heading} degrees fits nearly as well. Compare the overlays, or give an approximate heading or a landmark.</source>
        <translation>Eine Blickrichtung von {heading} Grad passt fast ebenso gut. Vergleichen Sie die Überlagerungen, oder geben Sie eine ungefähre Blickrichtung oder eine Landmarke an.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The fit is weak. Check the overlay, or give an approximate heading, a landmark or a sky mask.</source>
        <translation>Die Anpassung ist schwach. Prüfen Sie die Überlagerung, oder geben Sie eine ungefähre Blickrichtung, eine Landmarke oder eine Himmelsmaske an.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The DEM horizon does not follow the skyline that was found in the picture. Check the overlay, or give a sky mask, a drawn skyline or an approximate heading.</source>
        <translation>Der Horizont des DGM folgt nicht der im Bild gefundenen Horizontlinie. Prüfen Sie die Überlagerung, oder geben Sie eine Himmelsmaske, eine gezeichnete Horizontlinie oder eine ungefähre Blickrichtung an.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The photo's compass says {heading} degrees, which contradicts the heading found. Check the overlay, use the compass as a hint (COMPASS), or give an approximate heading.</source>
        <translation>Der Kompass des Fotos zeigt {heading} Grad; das widerspricht der gefundenen Blickrichtung. Prüfen Sie die Überlagerung, verwenden Sie den Kompass als Hinweis (COMPASS), oder geben Sie eine ungefähre Blickrichtung an.</translation>
    </message>
    <message>
        <location filename="../core/match/prior.py"/>
        <source>The photo has no focal length (35 mm equivalent). Give the horizontal field of view in HFOV_FIELD.</source>
        <translation>Das Foto hat keine kleinbildäquivalente Brennweite. Geben Sie den horizontalen Bildwinkel in HFOV_FIELD an.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>The skyline or the DEM's horizon is a straight line, which cannot be matched. Use a photo that shows a mountain skyline.</source>
        <translation>Die Horizontlinie oder der Horizont des DGM ist eine Gerade; sie lässt sich nicht zuordnen. Verwenden Sie ein Foto, das eine Horizontlinie von Bergen zeigt.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>The paper method does not test its result. Check the overlay, or use the robust method.</source>
        <translation>Das Verfahren des Aufsatzes prüft sein Ergebnis nicht. Prüfen Sie die Überlagerung, oder verwenden Sie das robuste Verfahren.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>A skyline was found in only {share} % of the columns. Use a photo that shows more of the skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>Nur in {share} % der Spalten wurde eine Horizontlinie gefunden. Verwenden Sie ein Foto, das mehr von ihr zeigt, oder geben Sie eine Himmelsmaske oder eine gezeichnete Horizontlinie an.</translation>
    </message>
    <message>
        <location filename="../core/paper/skyline.py"/>
        <source>The picture has no smooth region above a rough one.</source>
        <translation>Das Bild hat keinen glatten Bereich über einem rauen.</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>best guess</source>
        <translation>beste Vermutung</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>most likely of several</source>
        <translation>wahrscheinlichste von mehreren</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>HFOV</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Compass − found</source>
        <translation>Kompass − gefunden</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Eye elevation</source>
        <translation>Höhe des Auges</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/facts.py"/>
        <source>NCC</source>
        <translation>NCC</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>probability</source>
        <translation>Wahrscheinlichkeit</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>{chance} within 3°</source>
        <translation>{chance} innerhalb von 3°</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>picture with extracted skyline and DEM horizons</source>
        <translation>Bild mit erkannter Horizontlinie und Horizonten des DGM</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>extracted</source>
        <translation>erkannt</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>DEM at {heading}</source>
        <translation>DGM bei {heading}</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>alternatives</source>
        <translation>Alternativen</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Score</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>Camera heading and visible ground</source>
        <translation>Blickrichtung und sichtbares Gelände</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>All numbers and the DEM horizon</source>
        <translation>Alle Zahlen und der Horizont des DGM</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>All numbers</source>
        <translation>Alle Zahlen</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>All photographs</source>
        <translation>Alle Fotos</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Previous page</source>
        <translation>Vorige Seite</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Next page</source>
        <translation>Nächste Seite</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>photographs {first} to {last}</source>
        <translation>Fotos {first} bis {last}</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>whole map</source>
        <translation>ganze Karte</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>only this section of the map</source>
        <translation>nur dieser Kartenausschnitt</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Search names, cameras, dates and reasons</source>
        <translation>Namen, Kameras, Daten und Gründe durchsuchen</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Pages of cards</source>
        <translation>Seiten mit Fotokarten</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>{count} of {all} photographs</source>
        <translation>{count} von {all} Fotos</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>{first} to {last}</source>
        <translation>{first} bis {last}</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Recorded heading minus heading found, of accepted and confirmed photographs. Bias is the median with its 90 % interval, spread is robust; both leave out readings farther than {limit} from the others.</source>
        <translation>Aufgezeichnete minus gefundene Blickrichtung der angenommenen und bestätigten Fotos. Die systematische Abweichung ist der Median mit seinem 90-%-Intervall, die Streuung ist robust; beide lassen Ablesungen weg, die mehr als {limit} von den übrigen abweichen.</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Compasses</source>
        <translation>Kompasse</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Bias</source>
        <translation>Systematische Abweichung</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Off by more than 30°</source>
        <translation>Mehr als 30° daneben</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Near +90°, −90°, 180°</source>
        <translation>Nahe +90°, −90°, 180°</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Drift per hour</source>
        <translation>Änderung je Stunde</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>(turned)</source>
        <translation>(verdreht)</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <location filename="../core/report/facts.py"/>
        <source>{low} to {high}</source>
        <translation>{low} bis {high}</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Other values</source>
        <translation>Weitere Werte</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Compass</source>
        <translation>Kompass</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Position and elevation</source>
        <translation>Position und Höhe</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>DEM horizon</source>
        <translation>DGM-Horizont</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Heading, true</source>
        <translation>Blickrichtung, geographisch</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>90 % interval</source>
        <translation>90-%-Intervall</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pitch, + up</source>
        <translation>Nickwinkel, + aufwärts</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Roll, + right side down</source>
        <translation>Rollwinkel, + rechts abwärts</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Alternative {rank}</source>
        <translation>Alternative {rank}</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Within 3° of the truth</source>
        <translation>Höchstens 3° von der Wahrheit</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Score of alternative 2</source>
        <translation>Wertung der Alternative 2</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>NCC of the second peak</source>
        <translation>NCC des zweiten Gipfels</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Sharpness of the peak</source>
        <translation>Schärfe des Gipfels</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Residual, median</source>
        <translation>Abweichung, Median</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Columns compared</source>
        <translation>Verglichene Spalten</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Horizontal field of view</source>
        <translation>Horizontaler Bildwinkel</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Vertical field of view</source>
        <translation>Vertikaler Bildwinkel</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>35 mm equivalent, used</source>
        <translation>35-mm-Äquivalent, verwendet</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>35 mm equivalent, EXIF</source>
        <translation>35-mm-Äquivalent, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distortion k1, k2</source>
        <translation>Verzeichnung k1, k2</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>from true north</source>
        <translation>von geographisch Nord</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>from magnetic north</source>
        <translation>von magnetisch Nord</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>reference unknown</source>
        <translation>Bezug unbekannt</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Converted to true north</source>
        <translation>Auf geographisch Nord umgerechnet</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Recorded minus found</source>
        <translation>Aufgezeichnet minus gefunden</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pitch of the gimbal, + up</source>
        <translation>Nickwinkel des Gimbals, + aufwärts</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Roll of the gimbal, + right side down</source>
        <translation>Rollwinkel des Gimbals, + rechts abwärts</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Position error, EXIF</source>
        <translation>Positionsfehler, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Eye elevation, used</source>
        <translation>Höhe des Auges, verwendet</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>DEM under the eye</source>
        <translation>DGM unter dem Auge</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Eye above the DEM</source>
        <translation>Auge über dem DGM</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Altitude, EXIF</source>
        <translation>Höhe, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>sea level</source>
        <translation>Meeresspiegel</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>below sea level</source>
        <translation>unter dem Meeresspiegel</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>ellipsoid</source>
        <translation>Ellipsoid</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distance in view, median</source>
        <translation>Entfernung im Bild, Median</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distance in view, farthest</source>
        <translation>Entfernung im Bild, größte</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Cut by the DEM's edge in view</source>
        <translation>Im Bild am Rand des DGM abgeschnitten</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Grid north from true north</source>
        <translation>Gitternord von geographisch Nord</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Path</source>
        <translation>Pfad</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Size, upright</source>
        <translation>Größe, aufrecht</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Taken, camera's time</source>
        <translation>Aufgenommen, Zeit der Kamera</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Place and horizon</source>
        <translation>Ort und Horizont</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Eye and DEM</source>
        <translation>Auge und DGM</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>1 place</source>
        <translation>1 Ort</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>{count} places</source>
        <translation>{count} Orte</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Highest horizon</source>
        <translation>Höchster Horizont</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>at azimuth</source>
        <translation>beim Azimut</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Mean horizon</source>
        <translation>Mittlerer Horizont</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Median distance</source>
        <translation>Mittlere Entfernung (Median)</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Farthest</source>
        <translation>Am fernsten</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Cut by DEM edge</source>
        <translation>Am Rand des DGM abgeschnitten</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Void</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <location filename="../core/report/orientability.py"/>
        <source>Expected error of the heading</source>
        <translation>Erwarteter Fehler der Blickrichtung</translation>
    </message>
    <message>
        <location filename="../core/report/orientability.py"/>
        <source>Field of view {hfov}°</source>
        <translation>Bildwinkel {hfov}°</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Heading</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Within 3°</source>
        <translation>Innerhalb 3°</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Second best</source>
        <translation>Zweitbeste</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Residual</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>evidence</source>
        <translation>Anhaltspunkte</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>DEM horizon, answer</source>
        <translation>DGM-Horizont, Antwort</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>whole picture</source>
        <translation>ganzes Bild</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Parameters, DEM and software</source>
        <translation>Parameter, DGM und Software</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>language code: en</source>
        <translation>Sprachkürzel: de</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Made by {software}.</source>
        <translation>Erstellt von {software}.</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>The cards are in the folder {folder} beside this page: keep both together. They load nothing from the network.</source>
        <translation>Die Fotokarten liegen im Ordner {folder} neben dieser Seite: Lassen Sie beide zusammen. Aus dem Netz wird nichts geladen.</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>This page is self-contained and loads nothing from the network. Keys: j for the next photo, k for the previous one.</source>
        <translation>Diese Seite ist in sich geschlossen und lädt nichts aus dem Netz. Tasten: j für das nächste Foto, k für das vorige.</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>Compass minus heading found</source>
        <translation>Kompass minus gefundene Blickrichtung</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>{count} readings, median difference {median}.</source>
        <translation>{count} Ablesungen, Median der Abweichungen {median}.</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>hour of the day, camera's clock</source>
        <translation>Tageszeit in Stunden, Uhr der Kamera</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>most in one bar: {count}</source>
        <translation>höchster Balken: {count}</translation>
    </message>
    <message>
        <location filename="../core/skyline/evidence.py"/>
        <source>The picture has a single colour.</source>
        <translation>Das Bild hat nur eine Farbe.</translation>
    </message>
    <message>
        <location filename="../core/skyline/evidence.py"/>
        <source>The picture is only {width} x {height} pixels.</source>
        <translation>Das Bild hat nur {width} x {height} Pixel.</translation>
    </message>
    <message>
        <location filename="../core/skyline/given.py"/>
        <source>The drawn skyline has fewer than two points.</source>
        <translation>Die gezeichnete Horizontlinie hat weniger als zwei Punkte.</translation>
    </message>
    <message>
        <location filename="../core/skyline/given.py"/>
        <source>The supplied skyline or sky mask has no change from sky to terrain.</source>
        <translation>Die gegebene Horizontlinie oder Himmelsmaske hat keinen Übergang vom Himmel zum Gelände.</translation>
    </message>
    <message>
        <location filename="../core/skyline/plausible.py"/>
        <source>The picture shows no skyline: no line separates sky from terrain.</source>
        <translation>Das Bild zeigt keine Horizontlinie: Keine Linie trennt Himmel und Gelände.</translation>
    </message>
    <message>
        <location filename="../core/skyline/plausible.py"/>
        <source>The picture shows no mountain skyline: its lines are level and upright, as in a room or on a page.</source>
        <translation>Das Bild zeigt keine Horizontlinie von Bergen: Seine Linien sind waagerecht und senkrecht wie in einem Raum oder auf einer Seite.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The clock cannot be determined: only {count} photos with a time, at least a minute apart, show a skyline, and {least} are needed. Give the clock's offset.</source>
        <translation>Die Uhr lässt sich nicht bestimmen: Nur {count} Fotos mit Aufnahmezeit, die mindestens eine Minute auseinanderliegen, zeigen eine Horizontlinie, {least} sind nötig. Geben Sie die Abweichung der Uhr an.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The clock cannot be determined from the skylines: other offsets fit as well. Give the clock's offset, or more photos with a clear skyline from different places.</source>
        <translation>Die Uhr lässt sich aus den Horizontlinien nicht bestimmen: Andere Abweichungen passen ebenso gut. Geben Sie die Abweichung der Uhr an, oder mehr Fotos mit klarer Horizontlinie von verschiedenen Orten.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The camera's clock is ahead by {offset} s (90 % interval: {lo} to {hi} s); {count} photos agree.</source>
        <translation>Die Kamerauhr geht um {offset} s vor (90-%-Intervall: {lo} bis {hi} s); {count} Fotos stimmen überein.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The track has fewer than two points with a time. Choose a recorded track, not a planned route.</source>
        <translation>Der Track hat weniger als zwei Punkte mit Zeit. Wählen Sie einen aufgezeichneten Track, keine geplante Route.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The photo was taken {time} before the track begins.</source>
        <translation>Das Foto wurde {time} vor dem Beginn des Tracks aufgenommen.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The photo was taken {time} after the track ends.</source>
        <translation>Das Foto wurde {time} nach dem Ende des Tracks aufgenommen.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The track has a gap of {time} around the photo.</source>
        <translation>Der Track hat um das Foto eine Lücke von {time}.</translation>
    </message>
    <message>
        <location filename="../core/track/zone.py"/>
        <source>The time zone {text} is not known. Write it as +05:45 or as Asia/Kathmandu.</source>
        <translation>Die Zeitzone {text} ist nicht bekannt. Schreiben Sie sie als +05:45 oder als Asia/Kathmandu.</translation>
    </message>
    <message>
        <location filename="../core/viewshed/geometry.py"/>
        <source>The DEM's coordinate system distorts sight lines too strongly here. Use a DEM in a projected coordinate system, such as UTM.</source>
        <translation>Das Koordinatensystem des DGM verzerrt Sichtlinien hier zu stark. Verwenden Sie ein DGM in einem projizierten Koordinatensystem wie UTM.</translation>
    </message>
    <message>
        <location filename="../core/viewshed/geometry.py"/>
        <source>The DEM's coordinate system bends sight lines too strongly here (close to a pole of its grid). Use a DEM in a projected coordinate system, such as UTM or polar stereographic.</source>
        <translation>Das Koordinatensystem des DGM krümmt Sichtlinien hier zu stark (nahe einem Pol seines Gitters). Verwenden Sie ein DGM in einem projizierten Koordinatensystem wie UTM oder polar-stereographisch.</translation>
    </message>
    <message>
        <location filename="../core/workers/pool.py"/>
        <source>The process that worked on this photo ended unexpectedly, perhaps because memory ran out. Run this photo again by itself, or set a smaller number of worker processes.</source>
        <translation>Der Prozess, der dieses Foto bearbeitete, endete unerwartet, vielleicht weil der Speicher nicht reichte. Bearbeiten Sie dieses Foto noch einmal allein, oder wählen Sie weniger Arbeitsprozesse.</translation>
    </message>
    <message>
        <location filename="../core/workers/team.py"/>
        <source>No worker processes could be started ({reason}), so one process does all the work.</source>
        <translation>Es konnten keine Arbeitsprozesse gestartet werden ({reason}), daher erledigt ein Prozess die ganze Arbeit.</translation>
    </message>
</context>
</TS>
