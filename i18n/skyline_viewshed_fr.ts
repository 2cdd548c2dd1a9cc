<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>SkylineViewshed</name>
    <message>
        <location filename="../plugin.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Photos to viewsheds</source>
        <translation>Des photos aux bassins visuels</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Skyline Viewshed: choose photos and an elevation model, and run</source>
        <translation>Skyline Viewshed : choisir des photos et un modèle d'élévation, puis exécuter</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Begin with the mountain button in the toolbar, or in the Processing toolbox.</source>
        <translation>Commencez par le bouton montagne de la barre d'outils, ou dans la boîte à outils de traitements.</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Photo view</source>
        <translation>Vue photo</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Look at oriented photographs beside the map, correct and measure.</source>
        <translation>Regarder les photos orientées à côté de la carte, les corriger et y mesurer.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Folder of photographs</source>
        <translation>Dossier de photos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Include subfolders</source>
        <translation>Inclure les sous-dossiers</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Elevation model (DEM)</source>
        <translation>Modèle numérique de terrain (MNT)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Maximum distance (m)</source>
        <translation>Distance maximale (m)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Land-cover raster</source>
        <translation>Raster d'occupation du sol</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Photos</source>
        <translation>Photos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/orient_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Oriented photos</source>
        <translation>Photos orientées</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../panel/view/actions.py"/>
        <source>Viewshed</source>
        <translation>Bassin visuel</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Ground in view</source>
        <translation>Terrain visible</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Land cover in view</source>
        <translation>Occupation du sol visible</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Photos to orient again</source>
        <translation>Photos à orienter de nouveau</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Layer to update</source>
        <translation>Couche à mettre à jour</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Field with an approximate heading (°)</source>
        <translation>Champ d'un azimut approché (°)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Landmarks</source>
        <translation>Points de repère</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Updated layer</source>
        <translation>Couche mise à jour</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Orients some photographs of a layer again, with an approximate heading or landmarks if you give them, updates the layer, and computes anew the ground that its photographs show.</source>
        <translation>Oriente de nouveau quelques photos d'une couche, avec un cap approximatif ou des repères si vous en donnez, met à jour la couche et recalcule le terrain que montrent ses photos.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Reads geotagged JPEG photographs with QGIS's own importer, orients them, and computes the ground they show.</source>
        <translation>Lit des photos JPEG géolocalisées avec l'import de QGIS, les oriente et calcule le terrain qu'elles montrent.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Uses the headings that the cameras recorded, and computes the ground within the horizontal field of view. Phone compasses are often wrong by 5 to 10 degrees or more.</source>
        <translation>Utilise les azimuts enregistrés par les appareils et calcule le terrain dans l'angle de champ horizontal. Les boussoles des téléphones se trompent souvent de 5 à 10 degrés ou plus.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Counts the cells of each class of a land-cover raster within the ground that each oriented photograph shows.</source>
        <translation>Compte les cellules de chaque classe d'un raster d'occupation du sol dans le terrain que montre chaque photo orientée.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>JPEG and HEIC files with a GPS position.</source>
        <translation>Fichiers JPEG et HEIC avec une position GPS.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Also searches all subfolders.</source>
        <translation>Cherche aussi dans tous les sous-dossiers.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Raster of classes, in any coordinate system.</source>
        <translation>Raster de classes, dans n'importe quel système de coordonnées.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Points with heading, pitch, roll and field of view.</source>
        <translation>Points avec azimut, tangage, roulis et angle de champ.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of photographs that show each cell, on the DEM's grid; nodata if it is unknown.</source>
        <translation>Nombre de photos qui montrent chaque cellule, sur la grille du MNT ; nodata si ce nombre est inconnu.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>One multipolygon per photograph, with the area seen (m²) and the farthest distance (m).</source>
        <translation>Un multipolygone par photo, avec la surface vue (m²) et la distance maximale (m).</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Ground in view, with the number of cells of each class in fields class_1, class_2, ...</source>
        <translation>Terrain visible, avec le nombre de cellules de chaque classe dans les champs class_1, class_2, ...</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>The layer of oriented photos; select the photos and tick the box for selected features.</source>
        <translation>La couche des photos orientées ; sélectionnez les photos et cochez la case des entités sélectionnées.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>The layer that gets the new answers; usually the same one. It is changed.</source>
        <translation>La couche qui reçoit les nouveaux résultats ; en général la même. Elle est modifiée.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Approximate true heading, clockwise from north. The answer must be near it. NULL: none.</source>
        <translation>Azimut géographique approché, dans le sens horaire depuis le nord. La réponse doit se trouver à proximité. NULL : aucun.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Points on the map that are visible in photographs, with the fields photo, x and y.</source>
        <translation>Points de la carte visibles sur les photos, avec les champs photo, x et y.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: geotagged photos to viewsheds</source>
        <translation>Modèle : des photos géolocalisées aux bassins visuels</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: recorded headings to viewsheds</source>
        <translation>Modèle : des azimuts enregistrés aux bassins visuels</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: orient photos again</source>
        <translation>Modèle : orienter de nouveau des photos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: land cover that photos show</source>
        <translation>Modèle : occupation du sol montrée par les photos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Models</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Photographs</source>
        <translation>Photographies</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Terrain and visibility</source>
        <translation>Relief et visibilité</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>All in one</source>
        <translation>Tout en un</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>From the photo to the map</source>
        <translation>De la photo à la carte</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Checks and simulation</source>
        <translation>Contrôles et simulation</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Cancelled. Nothing was written.</source>
        <translation>Annulé. Rien n'a été écrit.</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>{name} cannot be kept in memory, as only vector layers can. Choose a temporary file, or name a file or folder.</source>
        <translation>{name} ne peut pas être gardé en mémoire ; seules les couches vectorielles le peuvent. Choisissez un fichier temporaire, ou indiquez un fichier ou un dossier.</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>{name} cannot be written: {folder} is not a folder you may write to.</source>
        <translation>{name} ne peut pas être écrit : {folder} n'est pas un dossier où vous pouvez écrire.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Directed viewshed</source>
        <translation>Bassin visuel dirigé</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>viewshed,visibility,photo,field of view,frustum,wedge,dem,sector</source>
        <translation>bassin visuel,visibilité,photo,angle de champ,pyramide de vue,secteur,MNT,viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Ground that oriented photographs show: cumulative raster and one polygon per photo</source>
        <translation>Terrain montré par des photos orientées : raster cumulé et un polygone par photo</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Tests for every cell of the elevation model in range whether it is visible from the camera and lies inside the picture. &lt;i&gt;Photo frame&lt;/i&gt; uses heading, pitch, roll and both fields of view; &lt;i&gt;heading wedge&lt;/i&gt; uses only the heading and the horizontal field of view; &lt;i&gt;full circle&lt;/i&gt; uses none of them.</source>
        <translation>Vérifie, pour chaque cellule du modèle numérique de terrain à portée, si elle est visible depuis l'appareil et se trouve dans l'image. &lt;i&gt;Cadre de la photo&lt;/i&gt; utilise l'azimut de visée, le tangage, le roulis et les deux angles de champ ; &lt;i&gt;secteur de visée&lt;/i&gt; utilise seulement l'azimut de visée et l'angle de champ horizontal ; &lt;i&gt;cercle complet&lt;/i&gt; n'en utilise aucun.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>The raster uses the DEM's grid and counts the photographs that show each cell; cells for which this is unknown are nodata. The polygons have the area on the ellipsoid (m²) and the farthest distance (m) as attributes. Azimuths count from true north and distances are ground metres, whatever the coordinate system.</source>
        <translation>Le raster utilise la grille du MNT et compte les photos qui montrent chaque cellule ; les cellules pour lesquelles ce nombre est inconnu sont nodata. Les polygones ont pour attributs la surface sur l'ellipsoïde (m²) et la plus grande distance (m). Les azimuts sont comptés depuis le nord géographique et les distances sont en mètres au sol, quel que soit le système de coordonnées.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Advanced options: layers with values per cell (distance, elevation angle, how much higher a target must be to be visible, position in the picture), probabilities that account for the errors of pose, position and DEM, and the photographs' own skylines, which exclude ground that the foreground hides. Photographs from exactly the same place are computed together.</source>
        <translation>Options avancées : couches avec des valeurs par cellule (distance, angle de hauteur, de combien une cible doit être plus haute pour être visible, position dans l'image), probabilités tenant compte des erreurs d'orientation, de position et du MNT, et lignes d'horizon des photos elles-mêmes, qui excluent le terrain caché par le premier plan. Les photos prises exactement au même endroit sont calculées ensemble.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>To continue a run that was stopped, repeat it with the same parameters. Finished files in the folders of rasters, layers and probabilities are reused if the DEM, the pose and the settings have not changed.</source>
        <translation>Pour poursuivre un traitement interrompu, répétez-le avec les mêmes paramètres. Les fichiers terminés dans les dossiers des rasters, des couches et des probabilités sont réutilisés si le MNT, l'orientation et les réglages n'ont pas changé.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/panorama.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Oriented photo points</source>
        <translation>Points de photos orientées</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>From Orient photos, or any points with heading, pitch, roll and field of view.</source>
        <translation>Issus de « Orienter des photos », ou tout point avec azimut de visée, tangage, roulis et angle de champ.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the camera's elevation (m)</source>
        <translation>Champ de l'altitude de l'appareil (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Absolute elevation in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Altitude absolue dans le système altimétrique du MNT. NULL : MNT plus hauteur de l'appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Folder for one raster per photo</source>
        <translation>Dossier pour un raster par photo</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>GeoTIFFs: 1 seen, 0 not seen, nodata unknown.</source>
        <translation>GeoTIFF : 1 vu, 0 non vu, nodata inconnu.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of viewsheds</source>
        <translation>Nombre de bassins visuels</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>The layer has no heading. Choose the field that holds it, orient the photos first, or take the full circle.</source>
        <translation>La couche n'a pas d'azimut de visée. Choisissez le champ qui le contient, orientez d'abord les photos, ou prenez le cercle complet.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/export_headings.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the heading (°)</source>
        <translation>Champ de l'azimut de visée (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>True, clockwise from north.</source>
        <translation>Géographique, dans le sens horaire depuis le nord.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the horizontal field of view (°)</source>
        <translation>Champ de l'angle de champ horizontal (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Field of view of the upright picture.</source>
        <translation>Angle de champ de l'image redressée.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the pitch (°)</source>
        <translation>Champ du tangage (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Up is positive. NULL: wedge, not frame.</source>
        <translation>Positif vers le haut. NULL : secteur au lieu du cadre.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the roll (°)</source>
        <translation>Champ du roulis (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Right side down is positive. NULL: 0.</source>
        <translation>Positif si le côté droit est plus bas. NULL : 0.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Field with the vertical field of view (°)</source>
        <translation>Champ de l'angle de champ vertical (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>NULL: wedge, not frame.</source>
        <translation>NULL : secteur au lieu du cadre.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>End of the 90 % interval, used for probabilities. NULL: a standard deviation of 0.5° is used instead.</source>
        <translation>Borne de l'intervalle à 90 %, utilisée pour les probabilités. NULL : un écart type de 0,5° est utilisé à la place.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Field with the heading's lower end (°)</source>
        <translation>Champ de la borne inférieure de l'azimut de visée (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Field with the heading's upper end (°)</source>
        <translation>Champ de la borne supérieure de l'azimut de visée (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Drape photos over the terrain</source>
        <translation>Draper les photos sur le relief</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>orthophoto,drape,rectify,texture,mosaic,photo,rgba,ground sampling distance</source>
        <translation>orthophoto,draper,redresser,texture,mosaïque,photo,RGBA,résolution au sol</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Colour raster on the DEM's grid: each cell as the photo shows it, transparent where hidden</source>
        <translation>Raster en couleurs sur la grille du MNT : chaque cellule comme la photo la montre, transparente là où elle est cachée</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Each cell that a photograph shows gets the colour of the pixels that show it; all other cells are transparent. If several photographs show a cell, their colours are blended: the photograph with the finest resolution there has the greatest weight, and each photograph fades out towards its edges.</source>
        <translation>Chaque cellule montrée par une photo prend la couleur des pixels qui la montrent ; toutes les autres cellules sont transparentes. Si plusieurs photos montrent une cellule, leurs couleurs sont fondues : la photo dont la résolution y est la plus fine a le plus grand poids, et chaque photo s'estompe vers ses bords.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Sky is not draped: a cell whose pixel lies above the skyline of the picture stays transparent.</source>
        <translation>Le ciel n'est pas drapé : une cellule dont le pixel se trouve au-dessus de la ligne d'horizon de l'image reste transparente.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>The second raster gives the ground sampling distance of the best photo in metres per pixel: band 1 across the line of sight, band 2 along it on the slope, which is long if the line of sight grazes the ground. Trees and people in the picture are draped too, because the DEM does not contain them.</source>
        <translation>Le second raster donne la résolution au sol de la meilleure photo en mètres par pixel : bande 1 en travers de la ligne de visée, bande 2 le long de celle-ci sur la pente, grande si la ligne de visée rase le terrain. Les arbres et les personnes de l'image sont drapés aussi, car le MNT ne les contient pas.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Cells per side of a DEM cell</source>
        <translation>Cellules par côté d'une cellule du MNT</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>1: the DEM's own grid. 4: sixteen times as many cells, for a photo finer than the DEM.</source>
        <translation>1 : la grille du MNT. 4 : seize fois plus de cellules, pour une photo plus fine que le MNT.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Minimum distance (m)</source>
        <translation>Distance minimale (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Ground nearer than this is left out.</source>
        <translation>Le terrain plus proche est laissé de côté.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Draped photos</source>
        <translation>Photos drapées</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>GeoTIFF of red, green, blue and opacity; transparent where no photo sees the cell.</source>
        <translation>GeoTIFF de rouge, vert, bleu et opacité ; transparent là où aucune photo ne voit la cellule.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Ground sampling distance</source>
        <translation>Résolution au sol</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Metres per pixel of the best photo: band 1 across the view, band 2 along it.</source>
        <translation>Mètres par pixel de la meilleure photo : bande 1 en travers de la vue, bande 2 en long.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Number of photos draped</source>
        <translation>Nombre de photos drapées</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Number of cells with colour</source>
        <translation>Nombre de cellules colorées</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>The point names no photo.</source>
        <translation>Le point ne désigne aucune photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>{share} % of the ground in view lies where the picture shows sky, and was not draped. Check the heading, the pitch and the elevation of the camera.</source>
        <translation>{share} % du terrain visible tombent là où l'image montre le ciel et n'ont pas été drapés. Vérifiez l'azimut de visée, le tangage et l'altitude de l'appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Expected accuracy</source>
        <translation>Précision attendue</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>simulation,accuracy,benchmark,planning,acceptance,coverage,montecarlo</source>
        <translation>simulation,précision,banc d'essai,planification,acceptation,couverture,montecarlo</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>How accurate orientation will be at given places over a given DEM, from simulated photographs</source>
        <translation>Quelle précision aura l'orientation en des lieux donnés sur un MNT donné, d'après des photos simulées</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Simulates photographs from the places with random directions, lenses, weather and errors of position and focal length, orients each of them as Orient photos does, and compares the answers with the truth: errors, share of accepted photographs, wrong ones among them, and how often the 90 % interval holds the truth.</source>
        <translation>Simule des photos depuis les lieux avec des directions, objectifs, temps et erreurs de position et de focale aléatoires, oriente chacune comme le fait « Orienter des photos » et compare les réponses à la vérité : erreurs, part des photos acceptées, fausses parmi elles, et combien de fois l'intervalle à 90 % contient la vérité.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The simulated mountains are rougher than the DEM. Each photograph takes some seconds. Real photographs can give worse results: compare with the figures for real photographs in the documentation.</source>
        <translation>Les montagnes simulées sont plus rugueuses que le MNT. Chaque photo prend quelques secondes. De vraies photos peuvent donner de moins bons résultats : comparez avec les chiffres pour de vraies photos dans la documentation.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Places</source>
        <translation>Lieux</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Points, or lines along which places are taken.</source>
        <translation>Points, ou lignes le long desquelles des lieux sont pris.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Distance between the places that are taken along lines.</source>
        <translation>Distance entre les lieux pris le long des lignes.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Step along lines (m)</source>
        <translation>Pas le long des lignes (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>They are spread evenly over the places.</source>
        <translation>Elles sont réparties également entre les lieux.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Number of photographs</source>
        <translation>Nombre de photographies</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Weather</source>
        <translation>Temps</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>clear days</source>
        <translation>jours clairs</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>half clear, half a season's weather</source>
        <translation>moitié clair, moitié temps d'une saison</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>a season's weather</source>
        <translation>temps d'une saison</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>A season's weather has clouds, haze, trees, people and camera faults.</source>
        <translation>Le temps d'une saison comprend nuages, brume, arbres, personnes et défauts de l'appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Fields of view are drawn between the two.</source>
        <translation>Les angles de champ sont tirés entre les deux.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Narrowest field of view (°)</source>
        <translation>Angle de champ le plus étroit (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Widest field of view (°)</source>
        <translation>Angle de champ le plus large (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Standard deviation of the recorded position in each direction.</source>
        <translation>Écart type de la position enregistrée dans chaque direction.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Error of the position (m)</source>
        <translation>Erreur de la position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Roughness of the mountains that the DEM does not show, in cells of the DEM. 0: the photographs show the DEM itself.</source>
        <translation>Rugosité des montagnes que le MNT ne montre pas, en cellules du MNT. 0 : les photos montrent le MNT lui-même.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Roughness beyond the DEM</source>
        <translation>Rugosité au-delà du MNT</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The same seed gives the same photographs.</source>
        <translation>La même graine donne les mêmes photos.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>One point per simulated photograph with its truth, the answer and the error.</source>
        <translation>Un point par photo simulée avec sa vérité, la réponse et l'erreur.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Simulated photographs</source>
        <translation>Photographies simulées</translation>
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
        <translation>Nombre de photos</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/orient_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of accepted photos</source>
        <translation>Nombre de photos acceptées</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Accepted photos that are wrong by more than 3°</source>
        <translation>Photos acceptées fausses de plus de 3°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of headings within 1°</source>
        <translation>Part des azimuts à moins de 1°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of headings within 3°</source>
        <translation>Part des azimuts à moins de 3°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of the accepted whose interval holds the truth</source>
        <translation>Part des acceptées dont l'intervalle contient la vérité</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The narrowest field of view must not be wider than the widest.</source>
        <translation>L'angle de champ le plus étroit ne doit pas dépasser le plus large.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>None of the places has a usable position on this DEM.</source>
        <translation>Aucun des lieux n'a de position utilisable sur ce MNT.</translation>
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
        <translation>Le point n'a pas de position utilisable.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>{photos} photographs: {accepted} accepted, {wrong} of them wrong by more than 3°; {within} % of all headings are within 1° of the truth.</source>
        <translation>{photos} photographies : {accepted} acceptées, dont {wrong} fausses de plus de 3° ; {within} % de tous les azimuts sont à moins de 1° de la vérité.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>True heading (°)</source>
        <translation>Azimut vrai (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Heading found minus true heading (°)</source>
        <translation>Azimut trouvé moins azimut vrai (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Probability of a unique answer, predicted from the DEM</source>
        <translation>Probabilité d'une réponse unique, prévue d'après le MNT</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Place</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view (°)</source>
        <translation>Angle de champ horizontal (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Heading (° from true north)</source>
        <translation>Azimut de visée (° depuis le nord géographique)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The 90 % interval holds the true heading</source>
        <translation>L'intervalle à 90 % contient l'azimut vrai</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Probability that the heading is right within 3°</source>
        <translation>Probabilité que l'azimut soit juste à 3° près</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Status</source>
        <translation>Statut</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Export headings</source>
        <translation>Exporter les caps</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>photo,heading,export,xmp,sidecar,kml,kmz,photooverlay,csv,google earth,lightroom,digikam</source>
        <translation>photo,cap,exporter,xmp,sidecar,kml,kmz,photooverlay,csv,google earth,lightroom,digikam</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Headings as XMP sidecars, KML or KMZ with the pictures, and a CSV table</source>
        <translation>Caps en fichiers XMP annexes, KML ou KMZ avec les images, et un tableau CSV</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Writes the headings of oriented photographs for other programs. The photographs themselves are never changed.</source>
        <translation>Écrit les caps de photos orientées pour d'autres programmes. Les photos elles-mêmes ne sont jamais modifiées.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>&lt;b&gt;Sidecars&lt;/b&gt; are named IMG_1.jpg.xmp, as digiKam, darktable and ExifTool read them, with GPSImgDirection against true north. The folders below the photographs' common folder are kept, so choose that common folder to have each sidecar beside its photograph. Sidecars of other programs are left alone. &lt;b&gt;KMZ&lt;/b&gt; contains reduced pictures; &lt;b&gt;KML&lt;/b&gt; points to the originals. Google Earth shows each picture in its place.</source>
        <translation>Les &lt;b&gt;fichiers annexes&lt;/b&gt; s'appellent IMG_1.jpg.xmp, comme les lisent digiKam, darktable et ExifTool, avec GPSImgDirection par rapport au nord géographique. Les dossiers situés sous le dossier commun des photos sont conservés ; choisissez donc ce dossier commun pour avoir chaque fichier à côté de sa photo. Les fichiers d'autres programmes ne sont pas touchés. &lt;b&gt;KMZ&lt;/b&gt; contient des images réduites ; &lt;b&gt;KML&lt;/b&gt; renvoie aux originaux. Google Earth montre chaque image à sa place.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Only photographs with the status &lt;i&gt;accepted&lt;/i&gt; or &lt;i&gt;confirmed&lt;/i&gt;, or without a status, are exported, unless you request the doubtful ones too.</source>
        <translation>Seules les photos au statut &lt;i&gt;accepted&lt;/i&gt; ou &lt;i&gt;confirmed&lt;/i&gt;, ou sans statut, sont exportées, sauf si vous demandez aussi les douteuses.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Clockwise from true north.</source>
        <translation>Dans le sens horaire depuis le nord géographique.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Doubtful photos too</source>
        <translation>Photos douteuses aussi</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Exports photos whose heading is not reliable as well.</source>
        <translation>Exporte aussi les photos dont le cap n'est pas fiable.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>One XMP file per photo. Choose the photos' common folder to have each beside its photo.</source>
        <translation>Un fichier XMP par photo. Choisissez le dossier commun des photos pour avoir chacun à côté de sa photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Folder for XMP sidecars</source>
        <translation>Dossier des fichiers XMP annexes</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>KML or KMZ</source>
        <translation>KML ou KMZ</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>KMZ files (*.kmz);;KML files (*.kml)</source>
        <translation>Fichiers KMZ (*.kmz);;Fichiers KML (*.kml)</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>For Google Earth; a KMZ file contains the pictures.</source>
        <translation>Pour Google Earth ; un fichier KMZ contient les images.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>CSV files (*.csv)</source>
        <translation>Fichiers CSV (*.csv)</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>One line per photo, for spreadsheets.</source>
        <translation>Une ligne par photo, pour les tableurs.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Number of photos left out</source>
        <translation>Nombre de photos écartées</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Choose at least one output: the folder for sidecars, the KML file or the table.</source>
        <translation>Choisissez au moins une sortie : le dossier des fichiers annexes, le fichier KML ou le tableau.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>No photo of the layer has a heading that can be exported. Orient the photos first.</source>
        <translation>Aucune photo de la couche n'a de cap exportable. Orientez d'abord les photos.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>{count} headings exported.</source>
        <translation>{count} caps exportés.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../panel/model/session.py"/>
        <location filename="../core/many.py"/>
        <source>The point names no photo. Fill its path field.</source>
        <translation>Le point ne désigne aucune photo. Remplissez son champ de chemin.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out, because it has no heading.</source>
        <translation>écartée, car elle n'a pas de cap.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out, because its status is {status}.</source>
        <translation>écartée, car son statut est {status}.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out of the KML file, because its point has no position.</source>
        <translation>absente du fichier KML, car son point n'a pas de position.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left as it is, because another program wrote {path}.</source>
        <translation>inchangé, car un autre programme a écrit {path}.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Extract skyline</source>
        <translation>Extraire la ligne d'horizon</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>photo,skyline,horizon,sky,segmentation,ridge,overlay</source>
        <translation>photo,ligne d'horizon,horizon,ciel,segmentation,crête,superposition,skyline</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Boundary between sky and terrain in photographs, with a confidence per column</source>
        <translation>Limite entre le ciel et le terrain dans les photos, avec une confiance par colonne</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Writes one row per picture column. &lt;b&gt;column&lt;/b&gt; and &lt;b&gt;row&lt;/b&gt; are pixels of the full upright picture (the first pixel is 0; row is the first terrain pixel). &lt;b&gt;confidence&lt;/b&gt; ranges from 0 (no plausible boundary, interpolated) to 1.</source>
        <translation>Écrit une ligne par colonne de l'image. &lt;b&gt;column&lt;/b&gt; et &lt;b&gt;row&lt;/b&gt; sont des pixels de l'image entière redressée (le premier pixel vaut 0 ; row est le premier pixel de terrain). &lt;b&gt;confidence&lt;/b&gt; va de 0 (aucune limite plausible, interpolé) à 1.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>If the automatic skyline is wrong, correct the table by hand and use it in &lt;i&gt;Orient photos&lt;/i&gt; as &lt;i&gt;Drawn skylines&lt;/i&gt;. The overlays are PNG pictures for checking the skyline.</source>
        <translation>Si la ligne d'horizon automatique est fausse, corrigez la table à la main et utilisez-la dans &lt;i&gt;Orienter des photos&lt;/i&gt; comme &lt;i&gt;Lignes d'horizon dessinées&lt;/i&gt;. Les superpositions sont des images PNG qui servent à vérifier la ligne d'horizon.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Robust: finds the most likely line as a whole, even with haze, clouds and noise. Paper: uses the published filters, column by column.</source>
        <translation>Robuste : trouve la ligne la plus probable dans son ensemble, même avec de la brume, des nuages et du bruit. Article : utilise les filtres publiés, colonne par colonne.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Skylines</source>
        <translation>Lignes d'horizon</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>One row per picture column: photo, column and row (px of the upright picture), confidence (0 to 1).</source>
        <translation>Une ligne par colonne d'image : photo, colonne et ligne (px de l'image redressée), confiance (0 à 1).</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Folder of overlays</source>
        <translation>Dossier des superpositions</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>One PNG per photograph with its skyline.</source>
        <translation>Un PNG par photo avec sa ligne d'horizon.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Number of skylines</source>
        <translation>Nombre de lignes d'horizon</translation>
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
        <translation>Photo</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Column (px, from the left)</source>
        <translation>Colonne (px, depuis la gauche)</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Row (px, from the top)</source>
        <translation>Ligne (px, depuis le haut)</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Confidence (0 to 1)</source>
        <translation>Confiance (0 à 1)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Horizon profile</source>
        <translation>Profil d'horizon</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>horizon,skyline,panorama,sky view factor,shading,elevation angle,dem</source>
        <translation>horizon,ligne d'horizon,panorama,facteur de vue du ciel,masque,angle de hauteur,MNT</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Elevation angle and distance of the horizon around points, and their sky view factor</source>
        <translation>Hauteur angulaire et distance de l'horizon autour de points, et leur facteur de vue du ciel</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Computes the elevation angle, the distance and the position of the horizon for each point and azimuth. Azimuths count from true north and distances are ground metres in any coordinate system of the DEM. The earth's curvature and refraction are taken into account.</source>
        <translation>Calcule la hauteur angulaire, la distance et la position de l'horizon pour chaque point et chaque azimut. Les azimuts sont comptés depuis le nord géographique et les distances sont en mètres au sol dans tout système de coordonnées du MNT. La courbure de la Terre et la réfraction sont prises en compte.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>&lt;b&gt;clipped&lt;/b&gt; is true if the elevation model ends before the search range and there could be higher terrain beyond it. &lt;b&gt;svf&lt;/b&gt; is the sky view factor of the source point (1 = open sky).</source>
        <translation>&lt;b&gt;clipped&lt;/b&gt; est vrai si le MNT s'arrête avant la portée de recherche et qu'un terrain plus haut pourrait se trouver au-delà. &lt;b&gt;svf&lt;/b&gt; est le facteur de vue du ciel du point d'origine (1 = ciel dégagé).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Under Advanced you can add a raster with the sky view factor of each cell in an extent, which takes the cell's own slope into account (Dozier and Frew 1990).</source>
        <translation>Sous Avancé, vous pouvez ajouter un raster du facteur de vue du ciel de chaque cellule d'une emprise, qui tient compte de la pente propre de la cellule (Dozier et Frew 1990).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Positions of the observer's eye, in any coordinate system.</source>
        <translation>Positions de l'œil de l'observateur, dans tout système de coordonnées.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth step (°)</source>
        <translation>Pas d'azimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Spacing of the directions; it is rounded so that it divides the circle.</source>
        <translation>Écart entre les directions ; il est arrondi pour diviser le cercle.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../core/figures/profile.py"/>
        <source>Horizon</source>
        <translation>Horizon</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>One point per azimuth at the position of the horizon, with elevation angle (°) and distance (m).</source>
        <translation>Un point par azimut à la position de l'horizon, avec hauteur angulaire (°) et distance (m).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Number of points with a horizon</source>
        <translation>Nombre de points avec un horizon</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Source point</source>
        <translation>Point d'origine</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Azimuth (° from true north)</source>
        <translation>Azimut (° depuis le nord géographique)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Elevation angle of the horizon (°)</source>
        <translation>Hauteur angulaire de l'horizon (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Distance of the horizon (m)</source>
        <translation>Distance de l'horizon (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Cut off by the DEM's edge</source>
        <translation>Coupé par le bord du MNT</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Sky view factor of the source point</source>
        <translation>Facteur de vue du ciel du point d'origine</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Import mountain photos</source>
        <translation>Importer des photos de montagne</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>photo,exif,heic,jpeg,geotag,gps,import,focal length,compass</source>
        <translation>photo,EXIF,HEIC,JPEG,géolocalisation,GPS,import,focale,boussole</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Point layer of the photographs in a folder, with field of view and compass reference</source>
        <translation>Couche de points des photos d'un dossier, avec angle de champ et référence de la boussole</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Makes one point per photograph with a position. It writes the same fields as QGIS's &lt;i&gt;Import geotagged photos&lt;/i&gt; and adds what orientation needs: 35 mm equivalent, field of view, size of the upright picture, reference of the compass (true or magnetic), GPS error, camera.</source>
        <translation>Crée un point par photo qui a une position. Écrit les mêmes champs que &lt;i&gt;Importer des photos géolocalisées&lt;/i&gt; de QGIS et ajoute ce dont l'orientation a besoin : focale équivalente 35 mm, angle de champ, taille de l'image redressée, référence de la boussole (géographique ou magnétique), erreur GPS, appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Values that a file does not contain are NULL. The optional table of rejected photographs lists photographs without a usable position and files that cannot be read, with the reason.</source>
        <translation>Les valeurs qu'un fichier ne contient pas sont NULL. La table facultative des photos rejetées répertorie les photos sans position utilisable et les fichiers illisibles, avec la raison.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>JPEG and HEIC files, and PNG, TIFF and WebP files that record a position.</source>
        <translation>Fichiers JPEG et HEIC, et fichiers PNG, TIFF et WebP qui contiennent une position.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>One point per photograph at the recorded position, with the recorded altitude as Z.</source>
        <translation>Un point par photo à la position enregistrée, avec l'altitude enregistrée en Z.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Rejected photos</source>
        <translation>Photos rejetées</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Table of the files that produced no point, with the reason.</source>
        <translation>Table des fichiers qui n'ont produit aucun point, avec la raison.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Number of rejected photos</source>
        <translation>Nombre de photos rejetées</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>The photo has no GPS position.</source>
        <translation>La photo n'a pas de position GPS.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Label peaks in photos</source>
        <translation>Étiqueter les sommets dans les photos</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>peak,summit,mountain,name,label,annotate,prominence,openstreetmap,geonames</source>
        <translation>sommet,pic,montagne,nom,étiquette,annoter,proéminence,OpenStreetMap,GeoNames</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summits in the picture with visibility, distance and position; annotated PNG and SVG</source>
        <translation>Sommets dans l'image avec visibilité, distance et position ; PNG et SVG annotés</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Uses a point layer with names and heights (OpenStreetMap &lt;i&gt;natural=peak&lt;/i&gt;, GeoNames), or finds summits in the elevation model by their prominence. Each published summit is moved to the nearby top in the DEM, because published positions and coarse DEMs differ by hundreds of metres. Then its visibility in the photo is tested.</source>
        <translation>Utilise une couche de points avec noms et altitudes (OpenStreetMap &lt;i&gt;natural=peak&lt;/i&gt;, GeoNames), ou cherche les sommets dans le MNT d'après leur proéminence. Chaque sommet publié est déplacé vers le point haut voisin du MNT, car les positions publiées et les MNT grossiers diffèrent de centaines de mètres. Sa visibilité dans la photo est ensuite vérifiée.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Labels never overlap. The more important summit (by prominence, otherwise by height above the others in view) gets the better place. Labels without room are left out of the picture; the layer contains all summits.</source>
        <translation>Les étiquettes ne se chevauchent jamais. Le sommet le plus important (par proéminence, sinon par sa hauteur au-dessus des autres en vue) obtient la meilleure place. Les étiquettes sans place sont omises de l'image ; la couche contient tous les sommets.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summits in photos</source>
        <translation>Sommets dans les photos</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>One point for each photo and each summit in its frame, with name, distance (m) and position in the picture (px).</source>
        <translation>Un point pour chaque photo et chaque sommet dans son cadre, avec nom, distance (m) et position dans l'image (px).</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>One PNG and one SVG per photo with the names written in.</source>
        <translation>Un PNG et un SVG par photo avec les noms inscrits.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Folder for labelled photos</source>
        <translation>Dossier des photos étiquetées</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Number of summits in frame</source>
        <translation>Nombre de sommets dans le cadre</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Number of visible summits</source>
        <translation>Nombre de sommets visibles</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summit</source>
        <translation>Sommet</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Published height, otherwise height in the DEM (m)</source>
        <translation>Altitude publiée, sinon altitude dans le MNT (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Height of the DEM's top (m)</source>
        <translation>Altitude du point haut du MNT (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Moved to the DEM's top by (m)</source>
        <translation>Déplacé vers le point haut du MNT de (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Prominence in the DEM (m), if summits were searched</source>
        <translation>Proéminence dans le MNT (m), si les sommets ont été cherchés</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>visible, hidden, unknown</source>
        <translation>visible (visible), hidden (caché), unknown (inconnu)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Column (px)</source>
        <translation>Colonne (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Row (px)</source>
        <translation>Ligne (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Distance (m)</source>
        <translation>Distance (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Elevation angle (°)</source>
        <translation>Hauteur angulaire (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Locate photos</source>
        <translation>Localiser les photos</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>position,place,where,geolocation,photo,skyline,horizon,archive,search,gps,geotag</source>
        <translation>position,lieu,où,géolocalisation,photo,ligne d'horizon,horizon,archive,recherche,gps,geotag</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Where photographs were taken, from their skyline and a DEM alone</source>
        <translation>Où des photographies ont été prises, d'après leur ligne d'horizon et un MNT seulement</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Compares the skyline of each photograph with the horizons of all places of an area, and gives the place, heading, pitch and roll that fit best. No position is needed in the photographs.</source>
        <translation>Compare la ligne d'horizon de chaque photographie aux horizons de tous les lieux d'une zone et donne le lieu, l'azimut, le tangage et le roulis qui conviennent le mieux. Les photographies n'ont pas besoin de position.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>&lt;b&gt;status&lt;/b&gt; is &lt;i&gt;accepted&lt;/i&gt; (the place can be trusted), &lt;i&gt;ambiguous&lt;/i&gt; (compare the candidates), &lt;i&gt;rejected&lt;/i&gt; (the photograph was probably not taken in this area, or its skyline does not decide) or &lt;i&gt;failed&lt;/i&gt;. &lt;b&gt;p_correct&lt;/b&gt; is the probability that the place is within 500 m and the heading within 3 degrees of the truth.</source>
        <translation>&lt;b&gt;status&lt;/b&gt; est &lt;i&gt;accepted&lt;/i&gt; (le lieu est fiable), &lt;i&gt;ambiguous&lt;/i&gt; (comparez les candidats), &lt;i&gt;rejected&lt;/i&gt; (la photographie n'a probablement pas été prise dans cette zone, ou sa ligne d'horizon ne décide pas) ou &lt;i&gt;failed&lt;/i&gt;. &lt;b&gt;p_correct&lt;/b&gt; est la probabilité que le lieu soit à moins de 500 m et l'azimut à moins de 3 degrés de la vérité.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>The horizons of the area are computed once, about 2 ms for each place. Choose a folder for them to use them again. A wide view of far mountains can be located well; a telephoto view or a near slope cannot. A place can reveal where people live or were: use the answer responsibly.</source>
        <translation>Les horizons de la zone sont calculés une fois, environ 2 ms par lieu. Choisissez un dossier pour eux afin de les réutiliser. Une vue large de montagnes lointaines se localise bien ; un téléobjectif ou une pente proche, non. Un lieu peut révéler où des personnes vivent ou se trouvaient : utilisez la réponse de façon responsable.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>One point per photograph, in place of a folder. Its position is the centre of a search in a radius; otherwise it is only compared with the answer.</source>
        <translation>Un point par photographie, à la place d'un dossier. Sa position est le centre d'une recherche dans un rayon ; sinon, elle est seulement comparée à la réponse.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Best places</source>
        <translation>Meilleurs lieux</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>One point per photograph at the best place.</source>
        <translation>Un point par photographie au meilleur lieu.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Candidate places</source>
        <translation>Lieux candidats</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>The best places of each photograph, ranked, with the pose at each.</source>
        <translation>Les meilleurs lieux de chaque photographie, classés, avec la pose à chacun.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Regions of 90 % probability</source>
        <translation>Régions à 90 % de probabilité</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Polygons that hold 90 % of the probability if the photograph was taken in the area.</source>
        <translation>Polygones qui contiennent 90 % de la probabilité si la photographie a été prise dans la zone.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Distance between the places that are tried; the best of them are moved afterwards.</source>
        <translation>Distance entre les lieux essayés ; les meilleurs sont ensuite déplacés.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Spacing of the places (m)</source>
        <translation>Espacement des lieux (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <source>Field of view of the upright picture. NULL: computed from the focal length in the file.</source>
        <translation>Angle de champ de l'image droite. NULL : calculé d'après la focale du fichier.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Tried for photographs without a focal length and without a given field of view.</source>
        <translation>Essayé pour les photographies sans focale et sans angle de champ donné.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Narrowest field of view to try (°)</source>
        <translation>Angle de champ le plus étroit à essayer (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Widest field of view to try (°)</source>
        <translation>Angle de champ le plus large à essayer (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Greatest height of the camera above the ground, for towers and drones. Heights up to it are tried.</source>
        <translation>Plus grande hauteur de l'appareil au-dessus du sol, pour les tours et les drones. Les hauteurs jusqu'à elle sont essayées.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Greatest camera height (m)</source>
        <translation>Plus grande hauteur de l'appareil (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <source>Maximum distance of the mountains on the skyline, in metres on the ground.</source>
        <translation>Distance maximale des montagnes de la ligne d'horizon, en mètres au sol.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Largest index of horizons that is held in memory; a folder for the index has no such limit.</source>
        <translation>Plus grand index d'horizons tenu en mémoire ; un dossier pour l'index n'a pas cette limite.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Memory for the index (MB)</source>
        <translation>Mémoire pour l'index (Mo)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Keeps the horizons of the area, about 3 kB for each place, so that later runs start at once.</source>
        <translation>Garde les horizons de la zone, environ 3 ko par lieu, pour que les exécutions suivantes commencent aussitôt.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Folder for the index</source>
        <translation>Dossier pour l'index</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>A point without a photo</source>
        <translation>Un point sans photo</translation>
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
        <translation>Une erreur inattendue s'est produite pour cette photo. Veuillez la signaler en joignant le journal.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>{count} places are searched.</source>
        <translation>{count} lieux sont examinés.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Map to pixels</source>
        <translation>De la carte aux pixels</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>project,overlay,photo,pixel,visible,hidden,trail,outline,annotate,augmented</source>
        <translation>projeter,superposition,photo,pixel,visible,caché,sentier,contour,annoter,réalité augmentée</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Where points, lines and areas of the map appear in oriented photos, and what hides them</source>
        <translation>Où les points, lignes et surfaces de la carte apparaissent dans des photos orientées, et ce qui les cache</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Converts points, lines (such as a trail) and areas (such as a glacier's outline of 1900) to image coordinates. Lines and outlines follow the terrain and are cut where they disappear behind it or leave the picture. The state of each piece is &lt;b&gt;visible&lt;/b&gt;, &lt;b&gt;hidden&lt;/b&gt;, &lt;b&gt;outside&lt;/b&gt; or &lt;b&gt;unknown&lt;/b&gt; (no elevation there). For areas, the visible share is given as well.</source>
        <translation>Convertit des points, des lignes (comme un sentier) et des surfaces (comme le contour d'un glacier de 1900) en coordonnées image. Lignes et contours suivent le relief et sont coupés là où ils disparaissent derrière lui ou sortent de l'image. L'état de chaque morceau est &lt;b&gt;visible&lt;/b&gt; (visible), &lt;b&gt;hidden&lt;/b&gt; (caché), &lt;b&gt;outside&lt;/b&gt; (hors cadre) ou &lt;b&gt;unknown&lt;/b&gt; (pas d'altitude à cet endroit). Pour les surfaces, la part visible est également donnée.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>A point with a height is a summit if the ground at its place is lower. It is then moved to the nearby top in the DEM, as in &lt;i&gt;Label peaks in photos&lt;/i&gt;: published positions and coarse DEMs differ by hundreds of metres.</source>
        <translation>Un point doté d'une altitude est un sommet si le terrain à sa place est plus bas. Il est alors déplacé vers le point culminant voisin du MNT, comme dans &lt;i&gt;Étiqueter les sommets dans les photos&lt;/i&gt; : les positions publiées et les MNT grossiers diffèrent de centaines de mètres.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>The output has the coordinates of the picture as QGIS shows it without georeference: x to the right, y negative downwards from the upper left corner. Load it together with the photo. The fields &lt;b&gt;x_px&lt;/b&gt; and &lt;b&gt;y_px&lt;/b&gt; count from the centre of the first pixel, with y downwards.</source>
        <translation>La sortie a les coordonnées de l'image telle que QGIS la montre sans géoréférencement : x vers la droite, y négatif vers le bas depuis le coin supérieur gauche. Chargez-la avec la photo. Les champs &lt;b&gt;x_px&lt;/b&gt; et &lt;b&gt;y_px&lt;/b&gt; comptent depuis le centre du premier pixel, y vers le bas.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Map features</source>
        <translation>Entités de la carte</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points, lines or areas in any coordinate system. Heights are taken from the DEM; Z values are ignored.</source>
        <translation>Points, lignes ou surfaces dans tout système de coordonnées. Les altitudes viennent du MNT ; les valeurs Z sont ignorées.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/shared/summit_input.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Field with names</source>
        <translation>Champ des noms</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Written to the output and into the pictures.</source>
        <translation>Écrit dans la sortie et dans les images.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Points with a height that their ground does not reach are summits. NULL: the point lies on the ground.</source>
        <translation>Les points dont le terrain n'atteint pas l'altitude sont des sommets. NULL : le point est sur le terrain.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Height above ground (m)</source>
        <translation>Hauteur au-dessus du sol (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Height of points above the ground. Lines and areas lie on the ground.</source>
        <translation>Hauteur des points au-dessus du sol. Les lignes et les surfaces sont posées au sol.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Step along lines (px)</source>
        <translation>Pas le long des lignes (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines are followed in steps of this length.</source>
        <translation>Les lignes sont suivies par pas de cette longueur.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points in pictures</source>
        <translation>Points dans les images</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points in pixels of the photo as QGIS shows it (not rotated), with negative y for rows; x_px and y_px count on the upright picture. The field state tells whether the photo shows them.</source>
        <translation>Points en pixels de la photo telle que QGIS la montre (non tournée), avec y négatif pour les lignes ; x_px et y_px comptent sur l'image redressée. Le champ state dit si la photo les montre.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines and outlines in pictures</source>
        <translation>Lignes et contours dans les images</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines and outlines in pixels of the photo as QGIS shows it (not rotated), with negative y for rows, cut where their visibility changes.</source>
        <translation>Lignes et contours en pixels de la photo telle que QGIS la montre (non tournée), avec y négatif pour les lignes, coupés là où leur visibilité change.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>One PNG and one SVG per photo with the features drawn in; hidden parts are dashed.</source>
        <translation>Un PNG et un SVG par photo avec les entités dessinées ; les parties cachées sont en tirets.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Folder for annotated photos</source>
        <translation>Dossier des photos annotées</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Number of points and pieces</source>
        <translation>Nombre de points et de morceaux</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Number of visible points and pieces</source>
        <translation>Nombre de points et de morceaux visibles</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines in pictures</source>
        <translation>Lignes dans les images</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Measure angular offsets</source>
        <translation>Mesurer les écarts angulaires</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>accuracy,landmark,offset,skyline,evaluation,table</source>
        <translation>précision,point de repère,écart,ligne d'horizon,évaluation,table</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Angular offsets between extracted and synthetic skyline from landmark pairs</source>
        <translation>Écarts angulaires entre ligne d'horizon extraite et synthétique, d'après des paires de points de repère</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Each row of the table is one feature, a summit or a notch, clicked on the skyline of the photograph (extracted) and on the projected horizon (synthetic), in pixels of the upright picture. Offsets are synthetic minus extracted: azimuth positive to the right, elevation positive upwards.</source>
        <translation>Chaque ligne de la table est un détail, un sommet ou une brèche, pointé sur la ligne d'horizon de la photo (extrait) et sur l'horizon projeté (synthétique), en pixels de l'image redressée. Les écarts sont synthétique moins extrait : en azimut positifs vers la droite, en hauteur positifs vers le haut.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table needs the fields photo, x_extracted, y_extracted, x_synthetic, y_synthetic (or x1, y1, x2, y2). Picture size and fields of view are read from the fields width, height, hfov and vfov if they exist, otherwise from the photo file by the published rule. The output contains the means of the absolute offsets per photograph; the means over all pairs are returned as results.</source>
        <translation>La table a besoin des champs photo, x_extracted, y_extracted, x_synthetic, y_synthetic (ou x1, y1, x2, y2). La taille de l'image et les angles de champ sont lus dans les champs width, height, hfov et vfov s'ils existent, sinon dans le fichier photo selon la règle publiée. La sortie contient les moyennes des écarts absolus par photo ; les moyennes sur toutes les paires sont renvoyées comme résultats.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Table of landmark pairs</source>
        <translation>Table des paires de points de repère</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>One row per pair; pixels of the upright picture.</source>
        <translation>Une ligne par paire ; pixels de l'image redressée.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Field {name}</source>
        <translation>Champ {name}</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>If this is empty, the first of {names} that the table contains is used.</source>
        <translation>Si ce champ est vide, le premier de {names} que la table contient est utilisé.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Offsets per photo</source>
        <translation>Écarts par photo</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>One row per photograph: number of pairs and mean offsets in azimuth, elevation and in total (°).</source>
        <translation>Une ligne par photo : nombre de paires et écarts moyens en azimut, en hauteur et au total (°).</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Number of pairs</source>
        <translation>Nombre de paires</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean azimuth offset over all pairs (°)</source>
        <translation>Écart moyen en azimut sur toutes les paires (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean elevation offset over all pairs (°)</source>
        <translation>Écart moyen en hauteur sur toutes les paires (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean total offset over all pairs (°)</source>
        <translation>Écart total moyen sur toutes les paires (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table has no complete pair. Fill photo and all four coordinates.</source>
        <translation>La table n'a pas de paire complète. Remplissez photo et les quatre coordonnées.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table has no field {field}. It has {fields}; choose the right one under Advanced.</source>
        <translation>La table n'a pas de champ {field}. Elle a {fields} ; choisissez le bon sous Avancé.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The photo has no focal length (35 mm equivalent). Give its fields of view in HFOV_FIELD.</source>
        <translation>La photo n'a pas de focale (équivalente 35 mm). Donnez ses angles de champ dans HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean azimuth offset (°)</source>
        <translation>Écart moyen en azimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean elevation offset (°)</source>
        <translation>Écart moyen en hauteur (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean total offset (°)</source>
        <translation>Écart total moyen (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean signed azimuth offset (°)</source>
        <translation>Écart moyen signé en azimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean signed elevation offset (°)</source>
        <translation>Écart moyen signé en hauteur (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Merge oriented photos</source>
        <translation>Fusionner des photos orientées</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>photo,heading,update,merge,rescue,again,ambiguous,rejected,join</source>
        <translation>photo,cap,mettre à jour,fusionner,sauvetage,de nouveau,ambigu,rejeté,joindre</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Updates a layer of oriented photos with photos that were oriented again</source>
        <translation>Met à jour une couche de photos orientées avec des photos orientées de nouveau</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>When a few photographs have been oriented again, with a hint or a landmark, this puts their answers into the layer that they came from. Photographs are recognised by their path; all others, all other fields and the points' positions stay as they are.</source>
        <translation>Quand quelques photos ont été orientées de nouveau, avec un indice ou un repère, ceci reporte leurs résultats dans la couche d'où elles viennent. Les photos sont reconnues par leur chemin ; toutes les autres, tous les autres champs et les positions des points restent tels quels.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>The layer itself is changed. If it is being edited, the changes join your unsaved ones and can be undone. Run &lt;i&gt;Directed viewshed&lt;/i&gt; on it afterwards to renew the ground in view, or use &lt;i&gt;Model: orient photos again&lt;/i&gt;, which does all three steps.</source>
        <translation>La couche elle-même est modifiée. Si elle est en cours d'édition, les changements s'ajoutent aux vôtres non enregistrés et peuvent être annulés. Exécutez ensuite &lt;i&gt;Bassin visuel dirigé&lt;/i&gt; sur elle pour renouveler le terrain visible, ou utilisez &lt;i&gt;Modèle : orienter de nouveau des photos&lt;/i&gt;, qui fait les trois étapes.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Oriented photos of an earlier run. This layer is changed.</source>
        <translation>Photos orientées d'une exécution antérieure. Cette couche est modifiée.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Photos that were oriented again</source>
        <translation>Photos orientées de nouveau</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>The output of Orient photos for some photos of that layer.</source>
        <translation>La sortie de « Orienter des photos » pour quelques photos de cette couche.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Keep a better status</source>
        <translation>Garder un meilleur statut</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>A photo whose new status is worse than its present one keeps its present answer.</source>
        <translation>Une photo dont le nouveau statut est moins bon que l'actuel garde son résultat actuel.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of updated photos</source>
        <translation>Nombre de photos mises à jour</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of photos that keep a better status</source>
        <translation>Nombre de photos qui gardent un meilleur statut</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of photos that the layer does not have</source>
        <translation>Nombre de photos que la couche n'a pas</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} cannot be changed. Save it as a GeoPackage first.</source>
        <translation>{name} ne peut pas être modifiée. Enregistrez-la d'abord en GeoPackage.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} has no field {field}. Choose a layer of oriented photos.</source>
        <translation>{name} n'a pas de champ {field}. Choisissez une couche de photos orientées.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name}: the layer does not have this photo.</source>
        <translation>{name} : la couche n'a pas cette photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name}: stays {before}; the new answer is {after}.</source>
        <translation>{name} : reste {before} ; le nouveau résultat est {after}.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../core/report/compass.py"/>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{count} photos updated.</source>
        <translation>{count} photos mises à jour.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} occurs more than once; its best status is used.</source>
        <translation>{name} apparaît plusieurs fois ; son meilleur statut est utilisé.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} cannot be changed now.</source>
        <translation>{name} ne peut pas être modifiée maintenant.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>a value does not fit its field</source>
        <translation>une valeur ne convient pas à son champ</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} was not changed: {reason}</source>
        <translation>{name} n'a pas été modifiée : {reason}</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Orient photos</source>
        <translation>Orienter des photos</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>photo,heading,azimuth,direction,orientation,pose,skyline,horizon,compass,pitch,roll</source>
        <translation>photo,azimut,direction,visée,orientation,pose,ligne d'horizon,horizon,boussole,tangage,roulis,heading</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Heading, pitch and roll of mountain photographs from their skyline and a DEM</source>
        <translation>Azimut de visée, tangage et roulis de photos de montagne d'après leur ligne d'horizon et un MNT</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Compares the skyline in each photograph with the horizon computed from the elevation model at its position, over all headings, and fits heading, pitch, roll and focal length. No compass is needed.</source>
        <translation>Compare la ligne d'horizon de chaque photo à l'horizon calculé à sa position d'après le modèle numérique de terrain, sur tous les azimuts, et ajuste azimut de visée, tangage, roulis et focale. Aucune boussole n'est nécessaire.</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>&lt;b&gt;status&lt;/b&gt; is &lt;i&gt;accepted&lt;/i&gt; (the answer can be trusted), &lt;i&gt;ambiguous&lt;/i&gt; (another heading fits nearly as well, or the fit is weak; see heading_2 and the report), &lt;i&gt;rejected&lt;/i&gt; (there is no usable skyline, or no heading fits) or &lt;i&gt;failed&lt;/i&gt; (the input cannot be used). &lt;b&gt;message&lt;/b&gt; gives the reason and suggests what to do. heading_lo and heading_hi enclose the true heading with a probability of 90 %. For an accepted photo this holds if its heading is the right one; &lt;b&gt;p_correct&lt;/b&gt; is the probability of that.</source>
        <translation>&lt;b&gt;status&lt;/b&gt; est &lt;i&gt;accepted&lt;/i&gt; (acceptée : la réponse est fiable), &lt;i&gt;ambiguous&lt;/i&gt; (ambiguë : un autre azimut convient presque aussi bien, ou l'ajustement est faible ; voir heading_2 et le rapport), &lt;i&gt;rejected&lt;/i&gt; (rejetée : il n'y a pas de ligne d'horizon utilisable, ou aucun azimut ne convient) ou &lt;i&gt;failed&lt;/i&gt; (échec : l'entrée n'est pas utilisable). &lt;b&gt;message&lt;/b&gt; donne la raison et suggère que faire. heading_lo et heading_hi encadrent le vrai azimut avec une probabilité de 90 %. Pour une photo acceptée, cela vaut si son azimut est le bon ; &lt;b&gt;p_correct&lt;/b&gt; en est la probabilité.</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Headings count clockwise from true north. A point's geometry is the camera's position. For photos that fail, give an approximate heading, a landmark, a drawn skyline or a sky mask (Advanced).</source>
        <translation>Les azimuts se comptent dans le sens horaire depuis le nord géographique. La géométrie d'un point est la position de l'appareil. Pour les photos qui échouent, donnez un azimut approché, un point de repère, une ligne d'horizon dessinée ou un masque de ciel (Avancé).</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>Orientability</source>
        <translation>Orientabilité</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>planning,camera,webcam,repeat photography,horizon,ambiguity,accuracy,prediction</source>
        <translation>planification,caméra,webcam,photographie répétée,horizon,ambiguïté,précision,prévision</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>How well a photo from a place could be oriented, by direction and field of view, from the DEM alone</source>
        <translation>Avec quelle qualité une photo prise d'un lieu pourrait être orientée, par direction et angle de champ, d'après le MNT seulement</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Compares each stretch of the horizon with all others, as a photograph of it would be compared, and predicts the probability that its heading is found and the error of that heading. Use it to plan cameras and repeat photography.</source>
        <translation>Compare chaque portion de l'horizon à toutes les autres, comme on comparerait une photographie, et prévoit la probabilité que son azimut soit trouvé et l'erreur de cet azimut. Sert à planifier des caméras et la photographie répétée.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>A horizon that repeats itself, a flat one and a narrow field of view are hard to orient, and the probability tells them from distinct ones. Where the terrain is distinct, photographs still fail on clouds, trees and near slopes, which the DEM does not show.</source>
        <translation>Un horizon qui se répète, un horizon plat et un champ de vision étroit sont difficiles à orienter, et la probabilité les distingue des horizons caractéristiques. Là où le terrain est caractéristique, des photos échouent encore à cause des nuages, des arbres et des pentes proches, que le MNT ne montre pas.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Horizontal fields of view (°)</source>
        <translation>Angles de champ horizontaux (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Numbers between 5 and 120, separated by commas.</source>
        <translation>Nombres entre 5 et 120, séparés par des virgules.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Standard deviation of the camera's position; it matters if terrain is near.</source>
        <translation>Écart type de la position de l'appareil ; il compte si du terrain est proche.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Extent of the raster</source>
        <translation>Emprise du raster</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Area of the optional raster.</source>
        <translation>Zone du raster facultatif.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Size of the cells of the raster, rounded to whole cells of the DEM.</source>
        <translation>Taille des cellules du raster, arrondie à des cellules entières du MNT.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Cells of the raster (m)</source>
        <translation>Cellules du raster (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>One point per place and field of view, with the probability in eight directions.</source>
        <translation>Un point par lieu et angle de champ, avec la probabilité dans huit directions.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Orientability of places</source>
        <translation>Orientabilité des lieux</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Bands: mean probability, probability in eight directions, and expected error (°), for the first field of view.</source>
        <translation>Bandes : probabilité moyenne, probabilité dans huit directions et erreur attendue (°), pour le premier angle de champ.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Number of places</source>
        <translation>Nombre de lieux</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Choose places, or an extent and a raster to write.</source>
        <translation>Choisissez des lieux, ou une emprise et un raster à écrire.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Choose the extent of the raster.</source>
        <translation>Choisissez l'emprise du raster.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>The fields of view must be numbers between 5 and 120, separated by commas.</source>
        <translation>Les angles de champ doivent être des nombres entre 5 et 120, séparés par des virgules.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Probability of a unique answer towards {direction}</source>
        <translation>Probabilité d'une réponse unique vers {direction}</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Mean probability of a unique answer</source>
        <translation>Probabilité moyenne d'une réponse unique</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Expected error of the heading (°)</source>
        <translation>Erreur attendue de l'azimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Outline panorama</source>
        <translation>Panorama au trait</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>panorama,horizon,skyline,ridge,outline,360,peaks,labels,svg</source>
        <translation>panorama,horizon,ligne d'horizon,crête,contour,360,sommets,étiquettes,SVG</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Labelled horizon and inner ridges in all directions from a point, as SVG, PNG and map lines</source>
        <translation>Horizon et crêtes intérieures étiquetés dans toutes les directions depuis un point, en SVG, PNG et lignes sur la carte</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>For each point, draws the horizon and every inner ridge that hides ground behind it. Near ridges are dark and thick, distant ones pale. Summits come from a layer, or are found in the DEM by their prominence. Optionally, the frames of oriented photos near the point are drawn.</source>
        <translation>Dessine, pour chaque point, l'horizon et chaque crête intérieure qui cache du terrain derrière elle. Les crêtes proches sont sombres et épaisses, les lointaines pâles. Les sommets viennent d'une couche, ou sont trouvés dans le MNT d'après leur proéminence. En option, les cadres des photos orientées proches du point sont dessinés.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The line layer holds the same ridges on the map, with distance and elevation angle.</source>
        <translation>La couche de lignes contient les mêmes crêtes sur la carte, avec distance et hauteur angulaire.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The frames of photos within 100 m of a point are drawn, from the fields heading, pitch, roll, hfov and vfov.</source>
        <translation>Les cadres des photos à moins de 100 m d'un point sont dessinés, d'après les champs heading, pitch, roll, hfov et vfov.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Angle between neighbouring rays.</source>
        <translation>Angle entre deux rayons voisins.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth at the left edge (°)</source>
        <translation>Azimut du bord gauche (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth at which the panorama begins.</source>
        <translation>Azimut auquel commence le panorama.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Pixels per degree</source>
        <translation>Pixels par degré</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Size of the drawing.</source>
        <translation>Taille du dessin.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Exaggeration of heights</source>
        <translation>Exagération des hauteurs</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>1: true shape.</source>
        <translation>1 : forme vraie.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>One PNG and one SVG per point.</source>
        <translation>Un PNG et un SVG par point.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Folder for panoramas</source>
        <translation>Dossier des panoramas</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Ridges in view</source>
        <translation>Crêtes en vue</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The drawn ridges as lines on the map, with distance (m) and elevation angle (°).</source>
        <translation>Les crêtes dessinées comme lignes sur la carte, avec distance (m) et hauteur angulaire (°).</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Number of panoramas</source>
        <translation>Nombre de panoramas</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>horizon or ridge</source>
        <translation>horizon (horizon) ou ridge (crête)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Begins at azimuth (° from true north)</source>
        <translation>Commence à l'azimut (° depuis le nord géographique)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Ends at azimuth (° from true north)</source>
        <translation>Finit à l'azimut (° depuis le nord géographique)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Median distance (m)</source>
        <translation>Distance médiane (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Highest elevation angle (°)</source>
        <translation>Plus grande hauteur angulaire (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Coverage of a photo collection</source>
        <translation>Couverture d'une collection de photos</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>coverage,blind spot,viewshed,cumulative,set cover,monitoring,fewest,photos,gsd</source>
        <translation>couverture,angle mort,bassin visuel,cumulé,couverture d'ensemble,suivi,moins de photos,résolution au sol</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>How often and how finely each cell is photographed, blind spots, and the fewest photos needed</source>
        <translation>Combien de fois et avec quelle finesse chaque cellule est photographiée, angles morts, et photos nécessaires les moins nombreuses</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Counts the photographs that see each cell of the area (0 is a blind spot) and gives the finest ground sampling distance among them in metres per pixel, across the line of sight.</source>
        <translation>Compte les photos qui voient chaque cellule de la zone (0 est un angle mort) et donne la résolution au sol la plus fine d'entre elles en mètres par pixel, en travers de la ligne de visée.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>The table gives how much each photograph shows, and which photographs are needed: as few as possible that together show everything the collection shows, in the order of how much each adds (&lt;b&gt;pick&lt;/b&gt;). PROVEN is true if it was proven that no smaller selection exists.</source>
        <translation>La table indique combien chaque photo montre, et quelles photos sont nécessaires : aussi peu que possible qui montrent ensemble tout ce que montre la collection, dans l'ordre de ce que chacune ajoute (&lt;b&gt;pick&lt;/b&gt;). PROVEN est vrai s'il a été prouvé qu'il n'existe pas de sélection plus petite.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Area</source>
        <translation>Étendue</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Only ground inside the area counts. If this is empty, all ground of the DEM within the maximum distance of the photos counts.</source>
        <translation>Seul le terrain à l'intérieur de la zone compte. Si aucune zone n'est indiquée, tout le terrain du MNT compte jusqu'à la distance maximale des photos.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Number of photographs that show each cell, on the DEM's grid. 0 is a blind spot; nodata is outside the area.</source>
        <translation>Nombre de photos qui montrent chaque cellule, sur la grille du MNT. 0 est un angle mort ; nodata est hors de la zone.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Best ground sampling distance</source>
        <translation>Meilleure résolution au sol</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Metres per pixel of the best photo, across the view.</source>
        <translation>Mètres par pixel de la meilleure photo, en travers de la vue.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Photos and what they add</source>
        <translation>Photos et ce qu'elles ajoutent</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>One row per photograph with the ground that it shows and, if it is needed, its place in the selection.</source>
        <translation>Une ligne par photo avec le terrain qu'elle montre et, si elle est nécessaire, sa place dans la sélection.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Share of the area seen by at least one</source>
        <translation>Part de la zone vue par au moins une</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Number of cells that no photo sees</source>
        <translation>Nombre de cellules qu'aucune photo ne voit</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Fewest photos that see all that the collection sees</source>
        <translation>Photos les moins nombreuses qui montrent tout ce que montre la collection</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>No smaller choice exists</source>
        <translation>Il n'existe pas de choix plus petit</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>None of the points is an oriented photo of a chosen status on this DEM.</source>
        <translation>Aucun des points n'est une photo orientée ayant un statut choisi sur ce MNT.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>The area is empty, or lies outside the region for which the DEM's CRS is valid.</source>
        <translation>La zone est vide, ou se trouve hors de la région pour laquelle le SCR du MNT est valable.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>photo,viewshed,heading,orientation,skyline,visibility,heic,exif,report,batch</source>
        <translation>photo,bassin visuel,azimut,orientation,ligne d'horizon,visibilité,HEIC,EXIF,rapport,lot,viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>From mountain photographs and a DEM to headings, ground in view and a report</source>
        <translation>De photos de montagne et d'un MNT aux azimuts de visée, au terrain visible et à un rapport</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Reads geotagged photographs, finds the heading of each from its skyline and the elevation model, and computes the ground that it shows. Choose a folder or a layer of photo points.</source>
        <translation>Lit des photos géolocalisées, trouve l'azimut de visée de chacune d'après sa ligne d'horizon et le modèle numérique de terrain, et calcule le terrain qu'elle montre. Choisissez un dossier ou une couche de points de photos.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Open the report to check each match: it has one card per photograph, with the horizon drawn over the picture. Photographs with a doubtful heading (status &lt;i&gt;ambiguous&lt;/i&gt;) get no viewshed unless you request it under Advanced. With the &lt;i&gt;paper&lt;/i&gt; method, which does not test its answers, all photographs get one.</source>
        <translation>Ouvrez le rapport pour vérifier chaque appariement : il contient une fiche par photo, avec l'horizon dessiné sur l'image. Les photos dont l'azimut est douteux (statut &lt;i&gt;ambiguous&lt;/i&gt;) n'ont pas de bassin visuel, sauf si vous le demandez sous Avancé. Avec la méthode &lt;i&gt;article&lt;/i&gt;, qui ne vérifie pas ses réponses, toutes les photos en ont un.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Distances are ground metres and headings count from true north, whatever the coordinate systems.</source>
        <translation>Les distances sont des mètres au sol et les azimuts partent du nord géographique, quels que soient les systèmes de coordonnées.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Maximum viewshed distance from the camera, in metres on the ground.</source>
        <translation>Distance maximale du bassin visuel depuis l'appareil, en mètres au sol.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Viewsheds of doubtful photos too</source>
        <translation>Bassins visuels des photos douteuses aussi</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Search range of the horizon (m)</source>
        <translation>Portée de recherche de l'horizon (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Computes the ground for the best heading even if another heading is as likely.</source>
        <translation>Calcule le terrain pour le meilleur azimut même si un autre azimut est aussi probable.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Pixels to map (monoplotting)</source>
        <translation>Des pixels à la carte (monoplotting)</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>monoplotting,pixel,photo,georeference,digitise,glacier,labelme,coco,via,ellipse,accuracy</source>
        <translation>monoplotting,pixel,photo,géoréférencer,numériser,glacier,LabelMe,COCO,VIA,ellipse,précision</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Points, lines and areas drawn on oriented photos become map features with an error ellipse</source>
        <translation>Les points, lignes et surfaces dessinés sur des photos orientées deviennent des entités de carte avec une ellipse d'erreur</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Follows the line of sight of each pixel to the elevation model, with the earth's curvature and refraction. Lines and outlines are followed pixel by pixel and cut where the ground behind them jumps. If a pixel shows the sky, or its line of sight enters a void of the DEM or reaches its edge, the field &lt;b&gt;status&lt;/b&gt; records this.</source>
        <translation>Suit la ligne de visée de chaque pixel jusqu'au modèle numérique de terrain, avec la courbure de la Terre et la réfraction. Lignes et contours sont suivis pixel par pixel et coupés là où le terrain saute à l'arrière. Si un pixel montre le ciel, ou si sa ligne de visée entre dans une lacune du MNT ou atteint son bord, le champ &lt;b&gt;status&lt;/b&gt; l'indique.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>The error ellipse contains the true position with the chosen probability, given the uncertainties of heading, pitch, roll, focal length, position and DEM. &lt;b&gt;p_other&lt;/b&gt; is the probability that the pixel shows different ground, beyond an edge in the picture. It is often large near ridges.</source>
        <translation>L'ellipse d'erreur contient la vraie position avec la probabilité choisie, compte tenu des incertitudes de l'azimut, du tangage, du roulis, de la focale, de la position et du MNT. &lt;b&gt;p_other&lt;/b&gt; est la probabilité que le pixel montre un autre terrain, au-delà d'une arête dans l'image. Elle est souvent grande près des crêtes.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Probability of the error ellipse (%)</source>
        <translation>Probabilité de l'ellipse d'erreur (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Probability that the ellipse contains the true position; 90 % is usual.</source>
        <translation>Probabilité que l'ellipse contienne la vraie position ; 90 % est usuel.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Lines and outlines are followed in steps of this length.</source>
        <translation>Les lignes et les contours sont suivis par pas de cette longueur.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Points on the map</source>
        <translation>Points sur la carte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Where the lines of sight of drawn points meet the ground, with status and distance (m).</source>
        <translation>Là où les lignes de visée des points dessinés rencontrent le sol, avec statut et distance (m).</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Lines on the map</source>
        <translation>Lignes sur la carte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Drawn lines on the ground, cut where the ground behind them jumps.</source>
        <translation>Lignes dessinées, au sol, coupées là où le terrain derrière elles saute.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Areas on the map</source>
        <translation>Surfaces sur la carte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Drawn areas on the ground.</source>
        <translation>Surfaces dessinées, au sol.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Error ellipses</source>
        <translation>Ellipses d'erreur</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>One ellipse per point, which contains the true position with the chosen probability.</source>
        <translation>Une ellipse par point, qui contient la vraie position avec la probabilité choisie.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Number of map features</source>
        <translation>Nombre d'entités de carte</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Number of features that show no ground</source>
        <translation>Nombre d'entités qui ne montrent aucun terrain</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Check photo positions</source>
        <translation>Vérifier les positions des photos</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>position,gps,check,wrong,shift,photo,skyline,horizon,quality</source>
        <translation>position,gps,vérifier,faux,décalage,photo,ligne d'horizon,horizon,qualité</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Whether the recorded position of a photo agrees with its skyline, and where a better place is</source>
        <translation>Si la position enregistrée d'une photo concorde avec sa ligne d'horizon, et où se trouve un meilleur lieu</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Orients each photograph from its recorded position and then tries places around it. If the skyline fits much better somewhere else, &lt;b&gt;verdict&lt;/b&gt; is &lt;i&gt;doubtful&lt;/i&gt;, and &lt;b&gt;dx&lt;/b&gt; and &lt;b&gt;dy&lt;/b&gt; give the way there in metres to the east and north. Positions are reported and never changed.</source>
        <translation>Oriente chaque photographie depuis sa position enregistrée puis essaie des lieux autour. Si la ligne d'horizon convient beaucoup mieux ailleurs, &lt;b&gt;verdict&lt;/b&gt; est &lt;i&gt;doubtful&lt;/i&gt;, et &lt;b&gt;dx&lt;/b&gt; et &lt;b&gt;dy&lt;/b&gt; donnent le chemin jusque-là en mètres vers l'est et le nord. Les positions sont signalées et jamais modifiées.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>A skyline of far mountains says little about a position: a &lt;i&gt;believable&lt;/i&gt; verdict only means that no place nearby fits much better. The error ellipse says how well the skyline fixes the better place.</source>
        <translation>Une ligne d'horizon de montagnes lointaines dit peu d'une position : un verdict &lt;i&gt;believable&lt;/i&gt; signifie seulement qu'aucun lieu proche ne convient beaucoup mieux. L'ellipse d'erreur dit avec quelle précision la ligne d'horizon fixe le meilleur lieu.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Rings of places are tried out to this distance; the larger it is, the farther apart they lie.</source>
        <translation>Des anneaux de lieux sont essayés jusqu'à cette distance ; plus elle est grande, plus ils sont espacés.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Search radius (m)</source>
        <translation>Rayon de recherche (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Checked positions</source>
        <translation>Positions vérifiées</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>The photo points with the verdict and the way to the better place.</source>
        <translation>Les points des photos avec le verdict et le chemin vers le meilleur lieu.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Number of doubtful positions</source>
        <translation>Nombre de positions douteuses</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Better place, metres to the east</source>
        <translation>Meilleur lieu, mètres vers l'est</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Better place, metres to the north</source>
        <translation>Meilleur lieu, mètres vers le nord</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Gain in agreement there</source>
        <translation>Gain de concordance à cet endroit</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Error ellipse (90 %), longer half axis (m)</source>
        <translation>Ellipse d'erreur (90 %), demi-grand axe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Error ellipse (90 %), shorter half axis (m)</source>
        <translation>Ellipse d'erreur (90 %), demi-petit axe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Azimuth of the longer half axis (°)</source>
        <translation>Azimut du demi-grand axe (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Position photos from a track</source>
        <translation>Positionner des photos d’après une trace</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>photo,gps,gpx,track,time,clock,geotag,position,exif,time zone</source>
        <translation>photo,gps,gpx,trace,heure,horloge,géolocalisation,position,exif,fuseau horaire</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Points of photographs without GPS, from the times of a recorded track</source>
        <translation>Points de photographies sans GPS, d’après les heures d’une trace enregistrée</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Makes one point per photograph at the place of the track at the photograph's time. The point's error (&lt;b&gt;pos_err&lt;/b&gt;) grows with the gap between the track points around it; &lt;i&gt;Orient photos&lt;/i&gt; takes it into account. If the track gives no position for that time, the point has no geometry and &lt;b&gt;pos_note&lt;/b&gt; says why.</source>
        <translation>Crée un point par photographie, au lieu de la trace à l’heure de la prise de vue. L’erreur du point (&lt;b&gt;pos_err&lt;/b&gt;) croît avec l’intervalle entre les points de trace qui l’entourent ; &lt;i&gt;Orienter des photos&lt;/i&gt; en tient compte. Si la trace ne donne pas de position pour cette heure, le point n’a pas de géométrie et &lt;b&gt;pos_note&lt;/b&gt; en donne la raison.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Cameras record local time. The time zone is read from the file, or taken from the parameter. If the clock was wrong, give its offset, or have it found &lt;i&gt;from the skylines&lt;/i&gt;: this needs an elevation model and at least three photographs with a clear skyline from different places, and takes a few minutes. If other offsets fit as well, no photograph is placed and a warning says so.</source>
        <translation>Les appareils enregistrent l’heure locale. Le fuseau horaire est lu dans le fichier ou pris dans le paramètre. Si l’horloge était déréglée, donnez son décalage ou faites-le déterminer &lt;i&gt;d’après les lignes d’horizon&lt;/i&gt; : il faut un modèle d’élévation et au moins trois photographies avec une ligne d’horizon nette, prises de lieux différents, et cela prend quelques minutes. Si d’autres décalages conviennent aussi bien, aucune photographie n’est positionnée et un avertissement l’indique.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>JPEG and HEIC files; a GPS position is not needed.</source>
        <translation>Fichiers JPEG et HEIC ; une position GPS n’est pas nécessaire.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Layer or table with the paths of the photographs, in place of a folder.</source>
        <translation>Couche ou table contenant les chemins des photographies, à la place d’un dossier.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Time zone of the camera's clock</source>
        <translation>Fuseau horaire de l’horloge de l’appareil</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>For example +05:45 or Asia/Kathmandu. Empty: as the photograph records it.</source>
        <translation>Par exemple +05:45 ou Asia/Kathmandu. Vide : celui qu’enregistre la photographie.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Camera's clock</source>
        <translation>Horloge de l’appareil</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>as given</source>
        <translation>comme indiqué</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>find its offset from the skylines</source>
        <translation>déterminer son décalage d’après les lignes d’horizon</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The skylines show where the photographs were taken, and so how much the clock is ahead: up to 14 hours to either side. At most 20 photographs are used, spread over the walk and at least a minute apart.</source>
        <translation>Les lignes d’horizon montrent où les photographies ont été prises, donc de combien l’horloge avance : jusqu’à 14 heures dans les deux sens. Au plus 20 photographies sont utilisées, réparties sur le parcours et espacées d’au moins une minute.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Seconds by which the camera's clock is ahead of the true time; negative if it is behind.</source>
        <translation>Secondes dont l’horloge de l’appareil avance sur l’heure vraie ; négatif si elle retarde.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Clock is ahead by (s)</source>
        <translation>L’horloge avance de (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Needed only to find the clock's offset from the skylines.</source>
        <translation>Nécessaire seulement pour déterminer le décalage de l’horloge d’après les lignes d’horizon.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Longest time between two track points that is interpolated; beyond the track's ends, half of it.</source>
        <translation>Durée maximale entre deux points de trace qui est interpolée ; au-delà de ses extrémités, la moitié.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Interpolation limit (s)</source>
        <translation>Limite d’interpolation (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Standard deviation of the track's points.</source>
        <translation>Écart-type des points de la trace.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Error of the track (m)</source>
        <translation>Erreur de la trace (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>One point per photograph, with the source of its position and its error; without geometry if there is no position.</source>
        <translation>Un point par photographie, avec l’origine de sa position et son erreur ; sans géométrie s’il n’y a pas de position.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Positioned photos</source>
        <translation>Photos positionnées</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Number of photos with a position</source>
        <translation>Nombre de photos avec une position</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Offset of the clock that was used (s)</source>
        <translation>Décalage de l’horloge qui a été utilisé (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Standard deviation of the clock's offset (s)</source>
        <translation>Écart-type du décalage de l’horloge (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Choose either a folder of photographs or a layer with their paths.</source>
        <translation>Choisissez soit un dossier de photographies, soit une couche contenant leurs chemins.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>To find the clock's offset from the skylines, choose an elevation model.</source>
        <translation>Pour déterminer le décalage de l’horloge d’après les lignes d’horizon, choisissez un modèle d’élévation.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>{placed} of {count} photos have a position.</source>
        <translation>{placed} photos sur {count} ont une position.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The photo records no time.</source>
        <translation>La photo n’enregistre pas d’heure.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The photo records no time zone. Give the time zone of the camera's clock.</source>
        <translation>La photo n’enregistre pas de fuseau horaire. Indiquez le fuseau horaire de l’horloge de l’appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>from the track</source>
        <translation>d’après la trace</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Time between the track points around the photo (s)</source>
        <translation>Durée entre les points de trace autour de la photo (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Where the position comes from, or why there is none</source>
        <translation>Provenance de la position, ou raison de son absence</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>One row per device, from accepted and confirmed photos: bias of the compass with its 90 % interval, spread, worthless and turned readings, and drift over the day.</source>
        <translation>Une ligne par appareil, d’après les photos acceptées et confirmées : biais de la boussole avec son intervalle à 90 %, dispersion, lectures sans valeur ou tournées, et dérive au cours de la journée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Compass audit</source>
        <translation>Audit des boussoles</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Maker, model and software</source>
        <translation>Fabricant, modèle et logiciel</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <location filename="../core/report/compass.py"/>
        <source>Readings</source>
        <translation>Lectures</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Recorded minus found heading, median (°)</source>
        <translation>Azimut enregistré moins azimut trouvé, médiane (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Lower limit of the bias, 90 % (°)</source>
        <translation>Limite inférieure du biais, 90 % (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Upper limit of the bias, 90 % (°)</source>
        <translation>Limite supérieure du biais, 90 % (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Robust standard deviation (°)</source>
        <translation>Écart-type robuste (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings off by more than 30°</source>
        <translation>Lectures à plus de 30° d’écart</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias + 90°</source>
        <translation>Lectures proches du biais + 90°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias − 90°</source>
        <translation>Lectures proches du biais − 90°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias + 180°</source>
        <translation>Lectures proches du biais + 180°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Too many of these for chance</source>
        <translation>Trop nombreuses pour être dues au hasard</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Change of the bias during a day (° per hour)</source>
        <translation>Variation du biais au cours d’une journée (° par heure)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Lower limit of the change, 90 % (° per hour)</source>
        <translation>Limite inférieure de la variation, 90 % (° par heure)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Upper limit of the change, 90 % (° per hour)</source>
        <translation>Limite supérieure de la variation, 90 % (° par heure)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <source>{count} photos are oriented first to test the compasses of the cameras.</source>
        <translation>{count} photos sont d'abord orientées pour vérifier les boussoles des appareils.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Cancelled after {done} of {count} photos.</source>
        <translation>Annulé après {done} photos sur {count}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <source>{camera}: about {percent} % of the compass readings are treated as worthless, because they contradict the skylines.</source>
        <translation>{camera} : environ {percent} % des indications de la boussole sont tenues pour sans valeur, car elles contredisent les lignes d'horizon.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photo point</source>
        <translation>Point de photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Cells of the area that it sees</source>
        <translation>Cellules de la zone qu'elle montre</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Share of the area that it sees</source>
        <translation>Part de la zone qu'elle montre</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Place among the fewest photos needed; NULL: not needed</source>
        <translation>Rang parmi les photos nécessaires les moins nombreuses ; NULL : pas nécessaire</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Cells that it adds to those picked before</source>
        <translation>Cellules qu'elle ajoute à celles choisies avant elle</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Share of the area seen by the picks up to here</source>
        <translation>Part de la zone montrée par les choix jusqu'ici</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>photographs that see the cell</source>
        <translation>photos qui voient la cellule</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>metres per pixel across the view, best photo</source>
        <translation>mètres par pixel en travers de la vue, meilleure photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>No photo shows any ground of this DEM, so there is nothing to drape.</source>
        <translation>Aucune photo ne montre de terrain de ce MNT : il n'y a rien à draper.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>red</source>
        <translation>rouge</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>green</source>
        <translation>vert</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>blue</source>
        <translation>bleu</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>opacity</source>
        <translation>opacité</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>metres per pixel across the view</source>
        <translation>mètres par pixel en travers de la vue</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>metres per pixel along the view</source>
        <translation>mètres par pixel le long de la vue</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/elevation.py"/>
        <source>The elevation model cannot be read. Choose a raster file with heights.</source>
        <translation>Le modèle numérique de terrain ne peut pas être lu. Choisissez un fichier raster contenant des altitudes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/elevation.py"/>
        <source>The elevation model comes from a {provider} source. Save it as a GeoTIFF first and choose that.</source>
        <translation>Le modèle numérique de terrain vient d'une source {provider}. Enregistrez-le d'abord en GeoTIFF et choisissez celui-ci.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/feedback.py"/>
        <source>{name} ({number}/{count})</source>
        <translation>{name} ({number}/{count})</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/field_names.py"/>
        <source>Fields renamed because the format of the output reserves the name: {names}</source>
        <translation>Champs renommés, car le format de sortie se réserve leur nom : {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <source>Choose a folder of photographs or a layer of photo points.</source>
        <translation>Choisissez un dossier de photos ou une couche de points de photos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <source>Choose either a folder of photographs or a layer of photo points, not both.</source>
        <translation>Choisissez soit un dossier de photos, soit une couche de points de photos, pas les deux.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>The folder {folder} does not exist.</source>
        <translation>Le dossier {folder} n'existe pas.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Map feature</source>
        <translation>Entité de la carte</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>visible, hidden, outside the frame, unknown</source>
        <translation>visible (visible), hidden (caché), outside (hors du cadre), unknown (inconnu)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance from the camera (m)</source>
        <translation>Distance à l'appareil (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Elevation (m)</source>
        <translation>Altitude (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Line or ring of the feature</source>
        <translation>Ligne ou anneau de l'entité</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Begins at this share of its length</source>
        <translation>Commence à cette part de sa longueur</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Ends at this share of its length</source>
        <translation>Finit à cette part de sa longueur</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Nearest distance (m)</source>
        <translation>Plus petite distance (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Farthest distance (m)</source>
        <translation>Plus grande distance (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Share of the whole feature that is visible</source>
        <translation>Part visible de l'entité entière</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>The map features are empty, or lie outside the region for which the DEM's CRS is valid.</source>
        <translation>Les entités de la carte sont vides, ou se trouvent hors de la région pour laquelle le SCR du MNT est valable.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <source>One file per photo (about 2 MB), for this plugin only. A repeated run reuses each orientation for which nothing has changed (photo, DEM, settings, version of the plugin), so a run that was stopped continues where it stopped.</source>
        <translation>Un fichier par photo (environ 2 Mo), pour cette extension seule. Une exécution répétée réutilise chaque orientation pour laquelle rien n'a changé (photo, MNT, réglages, version de l'extension), si bien qu'une exécution interrompue reprend là où elle s'est arrêtée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <source>Folder for finished orientations</source>
        <translation>Dossier des orientations terminées</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <location filename="../algorithms/shared/viewer.py"/>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>{name}: taken from {path}</source>
        <translation>{name} : repris de {path}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <location filename="../algorithms/shared/places_along.py"/>
        <source>The layer of points has no feature. Choose another, or clear the selection.</source>
        <translation>La couche de points n'a pas d'entité. Choisissez-en une autre ou videz la sélection.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>Point {id}</source>
        <translation>Point {id}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The layer has no field {field} ({name}). Choose another.</source>
        <translation>La couche n'a pas de champ {field} ({name}). Choisissez-en un autre.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <location filename="../panel/model/photo_layer.py"/>
        <source>The point layer has no coordinate reference system. Assign the right one in the layer's properties.</source>
        <translation>La couche de points n'a pas de système de coordonnées de référence. Attribuez le bon dans les propriétés de la couche.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The field {field} holds pictures, not paths. Save the pictures as files and choose a field with their paths (PHOTO_FIELD).</source>
        <translation>Le champ {field} contient des images, pas des chemins. Enregistrez les images comme fichiers et choisissez un champ avec leurs chemins (PHOTO_FIELD).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The layer has no field {field}. Choose the field that holds the photographs' paths.</source>
        <translation>La couche n'a pas de champ {field}. Choisissez le champ qui contient les chemins des photos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden</source>
        <translation>caché</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>outside the picture</source>
        <translation>hors de l'image</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>accepted: trust it</source>
        <translation>acceptée : fiable</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>confirmed by a person</source>
        <translation>confirmée par une personne</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>ambiguous: look at the report</source>
        <translation>ambiguë : voir le rapport</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>rejected: no answer</source>
        <translation>rejetée : pas de réponse</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>failed: input at fault</source>
        <translation>en échec : entrée en cause</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>not seen</source>
        <translation>non vu</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>1 photo</source>
        <translation>1 photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>2 photos</source>
        <translation>2 photos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>3 photos</source>
        <translation>3 photos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>4 to 5 photos</source>
        <translation>4 à 5 photos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>6 to 10 photos</source>
        <translation>6 à 10 photos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>more than 10 photos</source>
        <translation>plus de 10 photos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen</source>
        <translation>vu</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 200 m or more too low</source>
        <translation>caché, 200 m ou plus trop bas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 50 m too low</source>
        <translation>caché, 50 m trop bas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 10 m too low</source>
        <translation>caché, 10 m trop bas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>just hidden</source>
        <translation>tout juste caché</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>just seen</source>
        <translation>tout juste vu</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen, 10 m to spare</source>
        <translation>vu, 10 m de marge</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen, 100 m or more to spare</source>
        <translation>vu, 100 m de marge ou plus</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>1 (open sky)</source>
        <translation>1 (ciel dégagé)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>Answer</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Match</source>
        <translation>Appariement</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Table of lenses</source>
        <translation>Table des objectifs</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Distortion of known lenses, for example a CSV file: fields k1 and k2 (Brown, as in OpenCV), and at least one of make, model, lens, focal (mm) and f35 (mm), as in the photos' EXIF data; empty values fit all. The row that names most of a photo is used. Values in fields k1 and k2 of the points take precedence.</source>
        <translation>Distorsion d'objectifs connus, par exemple un fichier CSV : les champs k1 et k2 (Brown, comme dans OpenCV) et au moins l'un de make, model, lens, focal (mm) et f35 (mm), comme dans les données EXIF des photos ; les valeurs vides conviennent à toutes. La ligne qui nomme le plus de choses d'une photo est utilisée. Les valeurs des champs k1 et k2 des points ont priorité.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>{count} of {total} photos take k1 and k2 from the table of lenses.</source>
        <translation>{count} photos sur {total} prennent k1 et k2 dans la table des objectifs.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>No row of the table of lenses fits {count} photos, which are treated as free of distortion: {names}.</source>
        <translation>Aucune ligne de la table des objectifs ne convient à {count} photos, traitées comme exemptes de distorsion : {names}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Rows {first} and {second} of LENS_TABLE fit {photo} equally well. Name more of its lens in one.</source>
        <translation>Les lignes {first} et {second} de LENS_TABLE conviennent aussi bien à {photo}. Nommez davantage de son objectif dans l'une d'elles.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>no camera in the file</source>
        <translation>aucun appareil dans le fichier</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Radial distortion k1</source>
        <translation>Distorsion radiale k1</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Radial distortion k2</source>
        <translation>Distorsion radiale k2</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>The table LENS_TABLE needs the fields k1 and k2 and at least one of make, model, lens, focal and f35; it has {fields}.</source>
        <translation>La table LENS_TABLE a besoin des champs k1 et k2 et d'au moins l'un de make, model, lens, focal et f35 ; elle a {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>The table LENS_TABLE has no row.</source>
        <translation>La table LENS_TABLE n'a aucune ligne.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Rows {first} and {second} of LENS_TABLE give one lens different distortions. Delete one.</source>
        <translation>Les lignes {first} et {second} de LENS_TABLE donnent des distorsions différentes à un même objectif. Supprimez-en une.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE has no k1.</source>
        <translation>La ligne {row} de LENS_TABLE n'a pas de k1.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE names no camera, lens or focal length that it is for.</source>
        <translation>La ligne {row} de LENS_TABLE ne nomme ni appareil, ni objectif, ni focale auxquels elle s'applique.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE: {field} is {value}. Give one positive number for a focal length, and numbers with a decimal point for k1 and k2.</source>
        <translation>Ligne {row} de LENS_TABLE : {field} vaut {value}. Donnez un nombre positif pour une focale, et des nombres avec un point décimal pour k1 et k2.</translation>
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
        <translation>Tangage (°, + vers le haut)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Roll (°, + right side down)</source>
        <translation>Roulis (°, + côté droit plus bas)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Vertical field of view (°)</source>
        <translation>Angle de champ vertical (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Elevation of the camera (m)</source>
        <translation>Altitude de l'appareil (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Probability that place (500 m) and heading (3°) are right</source>
        <translation>Probabilité que le lieu (500 m) et l'azimut (3°) soient justes</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Agreement of the skyline with the horizon</source>
        <translation>Concordance de la ligne d'horizon avec l'horizon</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Correlation of place and focal length</source>
        <translation>Corrélation du lieu et de la focale</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Distance from the recorded position (m)</source>
        <translation>Distance à la position enregistrée (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Area (km²)</source>
        <translation>Surface (km²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_report.py"/>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_report.py"/>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lost_crs.py"/>
        <source>QGIS has lost the definition of the layer's coordinate reference system. Set the system in the layer's properties again, or remove the layer from the project and add it again.</source>
        <translation>QGIS a perdu la définition du système de coordonnées de la couche. Attribuez de nouveau le système dans les propriétés de la couche, ou retirez la couche du projet et ajoutez-la de nouveau.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/map_places.py"/>
        <source>A layer has no coordinate reference system. Assign the right one in the layer's properties.</source>
        <translation>Une couche n'a pas de système de coordonnées de référence. Attribuez le bon dans les propriétés de la couche.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Label</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>What the pixel shows: ground, sky, void, beyond the DEM, outside the frame</source>
        <translation>Ce que montre le pixel : ground (terrain), sky (ciel), void (lacune), beyond (au-delà du MNT), outside (hors de l'image)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Angle of incidence (°, 0 head-on)</source>
        <translation>Angle d'incidence (°, 0 de face)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Ground per pixel across the view (m)</source>
        <translation>Sol par pixel en travers de la vue (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Error ellipse, major half axis (m)</source>
        <translation>Ellipse d'erreur, demi-grand axe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Error ellipse, minor half axis (m)</source>
        <translation>Ellipse d'erreur, demi-petit axe (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Direction of the major axis (° from true north)</source>
        <translation>Direction du grand axe (° depuis le nord géographique)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Standard deviation of the elevation (m)</source>
        <translation>Écart type de l'altitude (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Probability that the pixel shows other ground, beyond an edge</source>
        <translation>Probabilité que le pixel montre un autre terrain, au-delà d'une arête</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance, 5 % quantile (m)</source>
        <translation>Distance, quantile 5 % (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance, 95 % quantile (m)</source>
        <translation>Distance, quantile 95 % (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>What it shows: ground, partly ground, sky, void, beyond the DEM, outside the frame</source>
        <translation>Ce qu'il montre : ground (terrain), partly ground (terrain en partie), sky (ciel), void (lacune), beyond (au-delà du MNT), outside (hors de l'image)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Share of its outline that lies on known ground</source>
        <translation>Part de son contour située sur un terrain connu</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Pieces, cut where the ground behind jumps</source>
        <translation>Morceaux, coupés là où le terrain saute à l'arrière</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Median of the error ellipses' major half axis (m)</source>
        <translation>Médiane des demi-grands axes des ellipses d'erreur (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Largest of the error ellipses' major half axis (m)</source>
        <translation>Plus grand demi-grand axe des ellipses d'erreur (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Mean probability that it shows other ground, beyond an edge</source>
        <translation>Probabilité moyenne qu'il montre un autre terrain, au-delà d'une arête</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Probability that the ellipse contains the true position</source>
        <translation>Probabilité que l'ellipse contienne la vraie position</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>The picture's size is unknown, so its pixels cannot be placed.</source>
        <translation>La taille de l'image est inconnue : ses pixels ne peuvent pas être situés.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>{count} of {total} image features reach beyond the picture of {width} x {height} pixels; nothing outside it is placed. Check that they were drawn on this picture, and not on a reduced, cropped or turned copy.</source>
        <translation>{count} objets image sur {total} dépassent de l'image de {width} x {height} pixels ; rien n'est placé en dehors. Vérifiez qu'ils ont été dessinés sur cette image et non sur une copie réduite, recadrée ou tournée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>mean probability</source>
        <translation>probabilité moyenne</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>expected error (°)</source>
        <translation>erreur attendue (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Field of view of the upright picture, across its middle. NULL: computed from the focal length in the file. Fields named k1 and k2 give the distortion of the lens (Brown, as in OpenCV).</source>
        <translation>Champ de vision de l'image redressée, en son milieu. NULL : calculé d'après la focale du fichier. Des champs nommés k1 et k2 donnent la distorsion de l'objectif (Brown, comme dans OpenCV).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Absolute elevation of the camera in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Altitude absolue de l'appareil dans le système altimétrique du MNT. NULL : MNT plus hauteur de l'appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Field with the error of the position (m)</source>
        <translation>Champ contenant l’erreur de la position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Standard deviation, as Position photos from a track writes it. NULL: a few metres, as GPS has in the open.</source>
        <translation>Écart-type, tel que l’écrit « Positionner des photos d’après une trace ». NULL : quelques mètres, comme le GPS à découvert.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Horizontal field of view of all photos (°)</source>
        <translation>Champ de vision horizontal de toutes les photos (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>For photographs of one lens without a focal length in their files, across the middle of the upright picture. A value in the field takes precedence.</source>
        <translation>Pour des photos d'un même objectif sans focale dans leurs fichiers, au milieu de l'image redressée. Une valeur dans le champ a priorité.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Camera at the recorded altitude</source>
        <translation>Appareil à l'altitude enregistrée</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>For towers, cable cars and drones: uses the altitude in the file, if it counts from sea level, instead of the DEM plus camera height. A phone's altitude is often wrong by 10 to 50 m. The elevation in the field with the camera's elevation takes precedence.</source>
        <translation>Pour les tours, les téléphériques et les drones : utilise l'altitude du fichier, si elle se compte depuis le niveau de la mer, au lieu du MNT plus la hauteur de l'appareil. L'altitude d'un téléphone est souvent fausse de 10 à 50 m. L'altitude du champ de l'altitude de l'appareil l'emporte.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>One point per photograph with all fields of the source, then heading, pitch, roll, field of view, their uncertainty, status and message.</source>
        <translation>Un point par photo avec tous les champs de la source, puis azimut, tangage, roulis, angle de champ, leur incertitude, statut et message.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>{count} photos: {parts}.</source>
        <translation>{count} photos : {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/outputs.py"/>
        <source>{path} cannot hold the fields of the photo points: {reason} Write a GeoPackage (.gpkg).</source>
        <translation>{path} ne peut pas contenir les champs des points photo : {reason} Écrivez un GeoPackage (.gpkg).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/outputs.py"/>
        <source>{name} could not be written.</source>
        <translation>{name} n'a pas pu être écrit.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/panorama_files.py"/>
        <source>panorama</source>
        <translation>panorama</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photo points</source>
        <translation>Points de photos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>One point per photograph, in any coordinate system, for example from Import geotagged photos. The point is the camera's position. If a point has no geometry, the position recorded in the photograph is used.</source>
        <translation>Un point par photo, dans tout système de coordonnées, par exemple issu de « Importer des photos géolocalisées ». Le point est la position de l'appareil. Si un point n'a pas de géométrie, la position inscrite dans la photo est utilisée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Field with the photo's path</source>
        <translation>Champ du chemin de la photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Full path of the photograph; a relative path counts from the layer's or the project's folder.</source>
        <translation>Chemin complet de la photo ; un chemin relatif part du dossier de la couche ou du projet.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Any raster with heights in metres and a coordinate system, projected or geographic. It should extend to the mountains that are visible.</source>
        <translation>Tout raster d'altitudes en mètres muni d'un système de coordonnées, projeté ou géographique. Il devrait s'étendre jusqu'aux montagnes visibles.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>DEM band</source>
        <translation>Bande du MNT</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Band that holds the heights.</source>
        <translation>Bande qui contient les altitudes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>as the file says</source>
        <translation>comme l'indique le fichier</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>feet (0.3048 m)</source>
        <translation>pieds (0,3048 m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>US survey feet</source>
        <translation>pieds d'arpentage américains</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>decimetres</source>
        <translation>décimètres</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>centimetres</source>
        <translation>centimètres</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>kilometres</source>
        <translation>kilomètres</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Unit of the heights</source>
        <translation>Unité des altitudes</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Unit of the heights in the elevation model. Many files in feet or decimetres do not say so; without any unit in the file, metres are assumed.</source>
        <translation>Unité des altitudes du modèle numérique. Beaucoup de fichiers en pieds ou en décimètres ne l'indiquent pas ; sans unité dans le fichier, des mètres sont supposés.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Maximum distance of the mountains on the skyline, in metres on the ground. The paper method uses at most 15 km.</source>
        <translation>Distance maximale des montagnes de la ligne d'horizon, en mètres au sol. La méthode article utilise au plus 15 km.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>robust</source>
        <translation>robuste</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>paper (as published)</source>
        <translation>article (telle que publiée)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Robust: exact camera geometry, a search over all headings, and an error bar. Paper: the published correlation of skylines on a flat earth, for comparison; it does not use the compass, hints, landmarks, drawn skylines or masks.</source>
        <translation>Robuste : géométrie exacte de l'appareil, recherche sur tous les azimuts et marge d'erreur. Article : la corrélation publiée des lignes d'horizon sur une terre plate, pour comparaison ; elle n'utilise ni boussole, ni indications, ni repères, ni lignes d'horizon dessinées, ni masques.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>ignore</source>
        <translation>ignorer</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>use as a hint</source>
        <translation>utiliser comme indice</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Ignore: the heading is found without the compass. Hint: the compass heading is a prior, wide enough for the usual errors of phones; a clear skyline overrules it.</source>
        <translation>Ignorer : l'azimut de visée est déterminé sans la boussole. Indication : l'azimut de la boussole est un a priori, assez large pour les erreurs habituelles des téléphones ; une ligne d'horizon nette l'emporte.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Ignore: no reading counts by itself; photos of a walk that are oriented together still compare their readings, which alone gives no heading. Hint: the compass heading is a prior, wide enough for the usual errors of phones; a clear skyline overrules it. If a camera has four or more photos, a sample of them is oriented first; if its compass often contradicts the skylines, it counts for less.</source>
        <translation>Ignorer : aucune indication ne compte à elle seule ; les photos d'une randonnée orientées ensemble comparent tout de même leurs indications, ce qui ne donne à soi seul aucun azimut de visée. Indication : l'azimut de la boussole est un a priori, assez large pour les erreurs habituelles des téléphones ; une ligne d'horizon nette l'emporte. Si un appareil a quatre photos ou plus, un échantillon en est d'abord orienté ; si sa boussole contredit souvent les lignes d'horizon, elle compte moins.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Recorded compass heading</source>
        <translation>Azimut de la boussole enregistré</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Camera height above ground (m)</source>
        <translation>Hauteur de l'appareil au-dessus du sol (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Metres above the elevation model.</source>
        <translation>Mètres au-dessus du MNT.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Distance from the camera in metres on the ground. Terrain beyond is ignored.</source>
        <translation>Distance depuis l'appareil en mètres au sol. Le terrain au-delà est ignoré.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Refraction coefficient</source>
        <translation>Coefficient de réfraction</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Share of the earth's curvature that refraction compensates; 0.13 is usual. The curvature itself is always applied.</source>
        <translation>Part de la courbure terrestre que la réfraction compense ; 0,13 est habituel. La courbure elle-même est toujours appliquée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>photo frame</source>
        <translation>cadre de la photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>heading wedge</source>
        <translation>secteur de visée</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>full circle</source>
        <translation>cercle complet</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photo frame: ground inside the picture, with pitch, roll and both fields of view. Heading wedge: all ground within the horizontal field of view. Full circle: all that can be seen from the place.</source>
        <translation>Cadre de la photo : terrain dans l'image, avec tangage, roulis et les deux angles de champ. Secteur de visée : tout le terrain dans l'angle de champ horizontal. Cercle complet : tout ce qui se voit depuis le lieu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>accepted</source>
        <translation>acceptée</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>confirmed</source>
        <translation>confirmée</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>ambiguous</source>
        <translation>ambiguë</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>rejected</source>
        <translation>rejetée</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photos by status</source>
        <translation>Photos par statut</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photos whose field status has one of these values are used; the log counts those that are left out. Photos of a layer without this field are all used.</source>
        <translation>Les photos dont le champ status a l'une de ces valeurs sont utilisées ; le journal compte celles qui sont écartées. Les photos d'une couche sans ce champ sont toutes utilisées.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>HTML files (*.html)</source>
        <translation>Fichiers HTML (*.html)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>One self-contained HTML file with figures, numbers and advice for each photo or point. From 201 photos on, the file is an index with a map, filters and thumbnails, and the cards are pages in a folder beside it.</source>
        <translation>Un fichier HTML autonome avec figures, chiffres et conseils pour chaque photo ou point. À partir de 201 photos, le fichier est un index avec carte, filtres et vignettes, et les fiches sont des pages dans un dossier à côté.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>without suffix</source>
        <translation>sans extension</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>Files that were not read as photographs: {kinds}</source>
        <translation>Fichiers qui n'ont pas été lus comme photos : {kinds}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>No photograph (JPEG, HEIC) was found in {folder}. Choose another folder, or include its subfolders.</source>
        <translation>Aucune photo (JPEG, HEIC) n'a été trouvée dans {folder}. Choisissez un autre dossier, ou incluez ses sous-dossiers.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/picture_files.py"/>
        <source>The point names no photo, so there is no picture to draw on.</source>
        <translation>Le point ne désigne aucune photo : il n'y a pas d'image sur laquelle dessiner.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/picture_files.py"/>
        <source>No installed font has all characters of {names}, so the PNG shows boxes; the SVG is right. Install a font for this script, for example a Noto Sans, and run again.</source>
        <translation>Aucune police installée n'a tous les caractères de {names} ; le PNG montre donc des carrés, le SVG est correct. Installez une police pour cette écriture, par exemple une Noto Sans, puis relancez.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Image features</source>
        <translation>Entités de l'image</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Points, lines or polygons as drawn in QGIS over the photo itself (not rotated, y negative), or in pixels of the upright picture with y counted downwards, or a table with fields x and y. A field photo names the photograph; without it the features belong to every photo.</source>
        <translation>Points, lignes ou polygones dessinés dans QGIS sur la photo elle-même (non tournée, y négatif), ou en pixels de l'image redressée avec y compté vers le bas, ou une table avec les champs x et y. Un champ photo nomme la photo ; sans lui, les entités appartiennent à toutes les photos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Image features from a labelling tool</source>
        <translation>Entités de l'image d'un outil d'annotation</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Label files (*.json *.geojson *.csv);;All files (*)</source>
        <translation>Fichiers d'annotation (*.json *.geojson *.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>LabelMe, COCO, VIA, GeoJSON with pixel coordinates, or CSV with photo, x, y (and feature, kind, label).</source>
        <translation>LabelMe, COCO, VIA, GeoJSON en coordonnées pixel, ou CSV avec photo, x, y (et feature, kind, label).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Give image features: a layer, or a file from a labelling tool.</source>
        <translation>Donnez des entités de l'image : une couche, ou un fichier d'un outil d'annotation.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>The image features are empty: draw something on a photo first.</source>
        <translation>Les entités de l'image sont vides : dessinez d'abord quelque chose sur une photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>The image features have neither a geometry in pixels nor fields x and y; they have {fields}.</source>
        <translation>Les entités de l'image n'ont ni géométrie en pixels ni champs x et y ; elles ont {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Several photos have these names, so the features were left out: {names}. Write the folders too, for example day1/IMG_0001.jpg.</source>
        <translation>Plusieurs photos portent ces noms ; les entités ont donc été omises : {names}. Indiquez aussi les dossiers, par exemple day1/IMG_0001.jpg.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>No oriented photo point for: {names}</source>
        <translation>Pas de point de photo orientée pour : {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Its features were drawn on a file of {bytes} bytes, which is another copy of this photo. If that copy is reduced, they are in the wrong place.</source>
        <translation>Les entités ont été dessinées sur un fichier de {bytes} octets, une autre copie de cette photo. Si cette copie est réduite, elles sont au mauvais endroit.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/previews.py"/>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/reporting.py"/>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/reporting.py"/>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Field with the tolerance of that heading (°)</source>
        <translation>Champ de la tolérance de cet azimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>How far the heading may differ from the approximate one. NULL: 20 degrees.</source>
        <translation>De combien l'azimut peut s'écarter de l'approché. NULL : 20 degrés.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Points on the map that are visible in photographs, with the fields photo, x and y (pixels of the upright picture; the first pixel is 0) and optionally elevation (m). One landmark is enough to determine the heading. If a field body says sun or moon, the pixel shows that, and no map point is needed: its direction follows from the time of the photograph.</source>
        <translation>Points de la carte visibles sur les photos, avec les champs photo, x et y (pixels de l'image redressée ; le premier pixel est 0) et, en option, elevation (m). Un repère suffit à déterminer le cap. Si un champ body indique sun ou moon, le pixel montre le Soleil ou la Lune et aucun point de la carte n'est nécessaire : la direction découle de l'heure de la photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Drawn skylines</source>
        <translation>Lignes d'horizon dessinées</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Table with fields photo, column and row (pixels of the upright picture): the vertices of the skyline.</source>
        <translation>Table avec les champs photo, column et row (pixels de l'image redressée) : les sommets de la ligne d'horizon.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Folder of sky masks</source>
        <translation>Dossier de masques de ciel</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Pictures named like the photographs (IMG_1.png for IMG_1.heic) in which the sky is white.</source>
        <translation>Images nommées comme les photos (IMG_1.png pour IMG_1.heic) dans lesquelles le ciel est blanc.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>{parameter}: several photos have the name {names}. Write the folders too, for example day1/IMG_0001.jpg; put sky masks into folders of the same names.</source>
        <translation>{parameter} : plusieurs photos portent le nom {names}. Indiquez aussi les dossiers, par exemple day1/IMG_0001.jpg ; placez les masques de ciel dans des dossiers de mêmes noms.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>LANDMARKS: the field body says {value}; it may say sun or moon, or be empty.</source>
        <translation>LANDMARKS : le champ body indique {value} ; il peut indiquer sun ou moon, ou être vide.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>The table {parameter} needs the fields photo, x and y (or column and row); it has {fields}.</source>
        <translation>La table {parameter} a besoin des champs photo, x et y (ou column et row) ; elle a {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>The folder of sky masks {folder} does not exist.</source>
        <translation>Le dossier de masques de ciel {folder} n'existe pas.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/result_figures.py"/>
        <source>PNG files with three panels: the photograph, the heading and field of view on the DEM, and the viewshed with the camera and, if the points have a timestamp, the path between the cameras.</source>
        <translation>Fichiers PNG en trois volets : la photo, l'azimut et l'angle de champ sur le MNT, et le bassin visuel avec l'appareil et, si les points ont un horodatage, le chemin entre les appareils.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/result_figures.py"/>
        <source>Folder for one figure per photo</source>
        <translation>Dossier pour une figure par photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>{name}: {verdict}, heading {heading}°</source>
        <translation>{name} : {verdict}, cap {heading}°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>{names} and {count} more</source>
        <translation>{names} et {count} autres</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>Check these photos ({verdict}): {names}</source>
        <translation>Vérifiez ces photos ({verdict}) : {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {seconds} s left</source>
        <translation>encore environ {seconds} s</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {minutes} min left</source>
        <translation>encore environ {minutes} min</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {hours} h left</source>
        <translation>encore environ {hours} h</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Polygons in which the photographs may have been taken.</source>
        <translation>Polygones dans lesquels les photographies peuvent avoir été prises.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Extent</source>
        <translation>Emprise</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Rectangle to search, if no area is given.</source>
        <translation>Rectangle à examiner, si aucune zone n'est donnée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Radius around the recorded position (m)</source>
        <translation>Rayon autour de la position enregistrée (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Searches around the position of each photograph, if neither an area nor an extent is given.</source>
        <translation>Cherche autour de la position de chaque photographie, si ni zone ni emprise n'est donnée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Paths</source>
        <translation>Chemins</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Only places near these lines are searched, for example hiking trails and roads.</source>
        <translation>Seuls les lieux proches de ces lignes sont examinés, par exemple sentiers et routes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Distance from the paths (m)</source>
        <translation>Distance aux chemins (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Places farther from the paths are not searched. It should be at least half the spacing.</source>
        <translation>Les lieux plus éloignés des chemins ne sont pas examinés. Elle doit valoir au moins la moitié de l'espacement.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Weights of places</source>
        <translation>Poids des lieux</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Raster with the relative probability that a photograph was taken at a place, for example from land cover or slope. Zero and nodata exclude a place.</source>
        <translation>Raster de la probabilité relative qu'une photographie ait été prise en un lieu, par exemple d'après l'occupation du sol ou la pente. Zéro et nodata excluent un lieu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Choose where to search: an area, an extent, or a radius around the recorded positions.</source>
        <translation>Choisissez où chercher : une zone, une emprise, ou un rayon autour des positions enregistrées.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The photo has no recorded position to search around. Choose an area or an extent.</source>
        <translation>La photo n'a pas de position enregistrée autour de laquelle chercher. Choisissez une zone ou une emprise.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The raster of weights excludes every place of the area. Choose another.</source>
        <translation>Le raster des poids exclut tous les lieux de la zone. Choisissez-en un autre.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>{name} has no usable feature. Choose another layer.</source>
        <translation>{name} n'a aucune entité utilisable. Choisissez une autre couche.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The area is empty. Choose a larger one, or a larger distance from the paths.</source>
        <translation>La zone est vide. Choisissez-en une plus grande, ou une plus grande distance aux chemins.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Extent of the sky view raster</source>
        <translation>Emprise du raster de vue du ciel</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Sky view factor of every cell of the DEM in the extent, its slope taken into account (1 = open sky).</source>
        <translation>Facteur de vue du ciel de chaque cellule du MNT dans l'emprise, compte tenu de sa pente (1 = ciel dégagé).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Empty: the whole DEM. A million cells take some ten seconds.</source>
        <translation>Vide : tout le MNT. Un million de cellules demande une dizaine de secondes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Search range of the sky view raster (m)</source>
        <translation>Portée de recherche du raster de vue du ciel (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Terrain beyond is ignored; distant mountains cover little of the sky.</source>
        <translation>Le terrain au-delà est ignoré ; les montagnes lointaines couvrent peu de ciel.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Sky view factor</source>
        <translation>Facteur de vue du ciel</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>The extent of the sky view raster does not overlap the DEM. Choose another.</source>
        <translation>L'emprise du raster de vue du ciel ne recoupe pas le MNT. Choisissez-en une autre.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>The search range of the sky view raster can be at most {most} m on a DEM with cells of {cell} m.</source>
        <translation>La portée de recherche du raster de vue du ciel peut être de {most} m au plus avec un MNT à cellules de {cell} m.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>sky view factor</source>
        <translation>facteur de vue du ciel</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Skylines of the photographs</source>
        <translation>Lignes d'horizon des photos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Table of Extract skyline (photo, column, row, confidence). Ground that would appear above its photo's skyline is hidden by something that is not in the DEM, such as trees or houses, and counts as not seen. Columns with a confidence below 0.5 exclude nothing. Requires the area photo frame.</source>
        <translation>Table d'Extraire la ligne d'horizon (photo, column, row, confidence). Le terrain qui apparaîtrait au-dessus de la ligne d'horizon de sa photo est caché par quelque chose qui n'est pas dans le MNT, comme des arbres ou des maisons, et compte comme non vu. Les colonnes dont la confiance est inférieure à 0,5 n'excluent rien. Demande l'étendue cadre de la photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Foreground hides ground</source>
        <translation>Le premier plan cache du terrain</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Ground that would appear above the photograph's own skyline is hidden by something that is not in the DEM, such as trees or houses, and counts as not seen. Requires the area photo frame.</source>
        <translation>Le terrain qui apparaîtrait au-dessus de la ligne d'horizon de la photo elle-même est caché par quelque chose qui n'est pas dans le MNT, comme des arbres ou des maisons, et compte comme non vu. Demande l'étendue cadre de la photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Tolerance above the skyline (°)</source>
        <translation>Tolérance au-dessus de la ligne d'horizon (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Ground up to this angle above the skyline still counts as seen, which allows for errors of the DEM and the heading.</source>
        <translation>Le terrain jusqu'à cet angle au-dessus de la ligne d'horizon compte encore comme vu, ce qui tient compte des erreurs du MNT et de l'azimut.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>The table of skylines has no field {field}. Choose the table that Extract skyline has written.</source>
        <translation>La table des lignes d'horizon n'a pas de champ {field}. Choisissez la table écrite par Extraire la ligne d'horizon.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>The table of skylines does not contain this photo, so no ground is excluded.</source>
        <translation>La table des lignes d'horizon ne contient pas cette photo ; aucun terrain n'est donc exclu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>{count} of {total} photos get no viewshed because of their status: {parts}.</source>
        <translation>{count} photos sur {total} n'obtiennent pas de bassin visuel à cause de leur statut : {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Their headings are doubtful: check them in the report. To compute their viewsheds all the same, tick "Viewsheds of doubtful photos too" under Advanced (parameter DOUBTFUL).</source>
        <translation>Leurs azimuts de visée sont douteux : vérifiez-les dans le rapport. Pour calculer quand même leurs bassins visuels, cochez « Bassins visuels des photos douteuses aussi » sous Avancé (paramètre DOUBTFUL).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>{count} of {total} photos are left out because of their status: {parts}.</source>
        <translation>{count} photos sur {total} sont écartées à cause de leur statut : {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>No photo is used, so the result is empty. {reason}</source>
        <translation>Aucune photo n'est utilisée, le résultat est donc vide. {reason}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Their headings are doubtful: check them in the report. To use them all the same, tick their statuses in "Photos by status" under Advanced (parameter STATUSES).</source>
        <translation>Leurs azimuts de visée sont douteux : vérifiez-les dans le rapport. Pour les utiliser quand même, cochez leurs statuts dans « Photos par statut » sous Avancé (paramètre STATUSES).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Photos with the status failed have no heading and cannot be used.</source>
        <translation>Les photos de statut failed n'ont pas d'azimut de visée et ne peuvent pas être utilisées.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/stored_style.py"/>
        <source>Style of the Skyline Viewshed plugin</source>
        <translation>Style de l'extension Skyline Viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/stored_style.py"/>
        <source>Other fields</source>
        <translation>Autres champs</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <location filename="../panel/view/actions.py"/>
        <source>Summits</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Points with names and heights, or an OpenStreetMap extract on your disk (.osm, .osm.pbf), of which the summits are read. Empty: summits are found in the DEM by their prominence.</source>
        <translation>Points avec noms et altitudes, ou un extrait d'OpenStreetMap sur votre disque (.osm, .osm.pbf), dont les sommets sont lus. Vide : les sommets sont cherchés dans le MNT d'après leur proéminence.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Summits without a name are left out.</source>
        <translation>Les sommets sans nom sont laissés de côté.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Text such as 4478, 4478 m or 14692 ft is read too. Heights that the DEM contradicts are not used.</source>
        <translation>Un texte comme 4478, 4478 m ou 14692 ft est lu aussi. Les altitudes que le MNT contredit ne sont pas utilisées.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Minimum prominence (m)</source>
        <translation>Proéminence minimale (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Prominence of the summits that are found in the DEM.</source>
        <translation>Proéminence des sommets trouvés dans le MNT.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Field with heights (m)</source>
        <translation>Champ des altitudes (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Search radius around a published summit (m)</source>
        <translation>Rayon de recherche autour d'un sommet publié (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>0: use the published position.</source>
        <translation>0 : utiliser la position publiée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM is used. The point may lie beside its summit: move it, or enlarge SNAP.</source>
        <translation>L'altitude publiée de {height} m contredit le MNT ({top} m à cet endroit) ; celle du MNT est donc utilisée. Le point est peut-être à côté de son sommet : déplacez-le ou augmentez SNAP.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM is used. If it is in feet, write 'ft' after it.</source>
        <translation>L'altitude publiée de {height} m contredit le MNT ({top} m à cet endroit) ; l'altitude du MNT est donc utilisée. Si elle est en pieds, écrivez 'ft' après.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The layer of summits has no field {field}. Choose the field with the names.</source>
        <translation>La couche de sommets n'a pas de champ {field}. Choisissez le champ des noms.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Orient the photos of a walk together</source>
        <translation>Orienter ensemble les photos d’une randonnée</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>The photos help one another: by features in common within 200 m (needs OpenCV), by the error of the compass, which one device shares for an hour, and by the focal length of their lens. Probability, interval and status then hold for all photos together. Accepted answers stay unless the others contradict them. A compass never gives a heading by itself. More than 300 photos are solved in blocks of 300, in the order of the layer; photos of different blocks do not help one another. The paper method ignores this.</source>
        <translation>Les photos s'aident entre elles : par des détails communs à moins de 200 m (OpenCV nécessaire), par l'erreur de la boussole, qu'un appareil garde pendant une heure, et par la focale de leur objectif. Probabilité, intervalle et statut valent alors pour toutes les photos ensemble. Les résultats acceptés restent, sauf si les autres les contredisent. Une boussole ne donne jamais à elle seule un azimut de visée. Au-delà de 300 photos, elles sont traitées par blocs de 300, dans l'ordre de la couche ; les photos de blocs différents ne s'aident pas. La méthode de l'article ignore ce réglage.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Photographs taken near one another or with one camera help one another, so a photograph may get a different answer in a group than alone. To orient each one by itself, turn off &lt;i&gt;Orient the photos of a walk together&lt;/i&gt; (Advanced).</source>
        <translation>Les photos prises à des endroits proches ou avec un même appareil s'aident entre elles ; une photo peut donc avoir dans un groupe un autre résultat que seule. Pour orienter chacune séparément, désactivez &lt;i&gt;Orienter ensemble les photos d’une randonnée&lt;/i&gt; (Avancé).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Cancelled while the photos were solved together.</source>
        <translation>Annulé pendant que les photos étaient résolues ensemble.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>The photos could not be solved together, so each keeps its own answer.</source>
        <translation>Les photos n'ont pas pu être résolues ensemble ; chacune garde son propre résultat.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>{count} photos gained from their neighbours.</source>
        <translation>{count} photos ont profité de leurs voisines.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Photographs that help one another</source>
        <translation>Photographies qui s’aident mutuellement</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Without OpenCV 4.4 or newer the photos are not compared by common features.</source>
        <translation>Sans OpenCV 4.4 ou plus récent, les photos ne sont pas comparées par leurs points communs.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Track (GPX file)</source>
        <translation>Trace (fichier GPX)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>A recorded track with times. Choose either a file or a layer.</source>
        <translation>Une trace enregistrée avec des heures. Choisissez soit un fichier, soit une couche.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Track (layer)</source>
        <translation>Trace (couche)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Points with a time, or lines whose M values are seconds since 1970 (UTC).</source>
        <translation>Points avec une heure, ou lignes dont les valeurs M sont des secondes depuis 1970 (UTC).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Field with the time</source>
        <translation>Champ contenant l’heure</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Date and time of each track point; without a time zone they count as UTC. Empty: a field named time.</source>
        <translation>Date et heure de chaque point de trace ; sans fuseau horaire, elles sont en UTC. Vide : un champ nommé time.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Choose the track: either a GPX file or a layer.</source>
        <translation>Choisissez la trace : soit un fichier GPX, soit une couche.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>The lines of the track have no M values with times. Choose a layer of points, or a GPX file.</source>
        <translation>Les lignes de la trace n’ont pas de valeurs M donnant l’heure. Choisissez une couche de points ou un fichier GPX.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>The track has no field with times. Choose the field that holds them.</source>
        <translation>La trace n’a pas de champ contenant des heures. Choisissez le champ qui les contient.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewer.py"/>
        <source>Cancelled after {done} of {count} viewsheds.</source>
        <translation>Annulé après {done} bassins visuels sur {count}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Up is positive. NULL: 0.</source>
        <translation>Positif vers le haut. NULL : 0.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Only used if the photograph itself is missing.</source>
        <translation>Utilisé seulement si la photo elle-même manque.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Absolute, in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Absolue, dans le système altimétrique du MNT. NULL : MNT plus hauteur de l'appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the heading (°)</source>
        <translation>Incertitude de l'azimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no heading_lo and heading_hi.</source>
        <translation>Écart type, utilisé si les points n'ont pas heading_lo et heading_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the pitch (°)</source>
        <translation>Incertitude du tangage (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no pitch_lo and pitch_hi.</source>
        <translation>Écart type, utilisé si les points n'ont pas pitch_lo et pitch_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the roll (°)</source>
        <translation>Incertitude du roulis (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no roll_lo and roll_hi.</source>
        <translation>Écart type, utilisé si les points n'ont pas roll_lo et roll_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the focal length (%)</source>
        <translation>Incertitude de la focale (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no hfov_lo and hfov_hi.</source>
        <translation>Écart type, utilisé si les points n'ont pas hfov_lo et hfov_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the position (m)</source>
        <translation>Incertitude de la position (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation of the camera's position, in east and in north. A field h_acc takes precedence.</source>
        <translation>Écart type de la position de l'appareil, vers l'est et vers le nord. Un champ h_acc l'emporte.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the camera's elevation (m)</source>
        <translation>Incertitude de l'altitude de l'appareil (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation.</source>
        <translation>Écart type.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Vertical error of the DEM (m)</source>
        <translation>Erreur altimétrique du MNT (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The picture's size is unknown, so a width of 4000 px is assumed.</source>
        <translation>La taille de l'image est inconnue ; une largeur de 4000 px est donc supposée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The photo has no horizontal field of view between 0 and 180 degrees; orient it first.</source>
        <translation>La photo n'a pas d'angle de champ horizontal entre 0 et 180 degrés ; orientez-la d'abord.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The photo has no heading; orient it first.</source>
        <translation>La photo n'a pas d'azimut de visée ; orientez-la d'abord.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Smallest area (m²)</source>
        <translation>Plus petite surface (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Smaller parts of a polygon are removed, and smaller holes are filled. 0 keeps everything.</source>
        <translation>Les parties plus petites d'un polygone sont supprimées, et les trous plus petits comblés. 0 garde tout.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Folder for layers per photo</source>
        <translation>Dossier des couches par photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>One float GeoTIFF per photo with named bands: distance (m), elevation angle (°), height above the line of sight (m; if negative, a target must be this much higher to be visible) and, if the pose is known, column and row in the picture (px). Nodata outside the area and range.</source>
        <translation>Un GeoTIFF à virgule flottante par photo, à bandes nommées : distance (m), angle de hauteur (°), hauteur au-dessus de la ligne de visée (m ; si elle est négative, une cible doit être d'autant plus haute pour être visible) et, si l'orientation est connue, colonne et ligne dans l'image (px). Nodata hors de l'étendue et de la portée.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Folder for probabilities per photo</source>
        <translation>Dossier des probabilités par photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>One GeoTIFF per photo with the probability (0 to 1) that the picture shows a cell, given the intervals of the pose and the errors below. Requires the area photo frame, and takes about five times as long.</source>
        <translation>Un GeoTIFF par photo avec la probabilité (0 à 1) que l'image montre une cellule, compte tenu des intervalles de l'orientation et des erreurs ci-dessous. Demande l'étendue cadre de la photo, et prend environ cinq fois plus de temps.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of positions (m)</source>
        <translation>Erreur des positions (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation along each axis, for probabilities.</source>
        <translation>Écart type selon chaque axe, pour les probabilités.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the DEM (m)</source>
        <translation>Erreur du MNT (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation of a cell's height relative to the terrain in front of it, for probabilities.</source>
        <translation>Écart type de la hauteur d'une cellule par rapport au terrain devant elle, pour les probabilités.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the pitch (°)</source>
        <translation>Erreur du tangage (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its pitch.</source>
        <translation>Écart type, pour les probabilités. Utilisé si la photo n'a pas d'intervalle du tangage.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the roll (°)</source>
        <translation>Erreur du roulis (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its roll. It mainly affects ground far from the picture's centre.</source>
        <translation>Écart type, pour les probabilités. Utilisé si la photo n'a pas d'intervalle du roulis. Il touche surtout le terrain loin du centre de l'image.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the focal length (%)</source>
        <translation>Erreur de la focale (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its field of view.</source>
        <translation>Écart type, pour les probabilités. Utilisé si la photo n'a pas d'intervalle de l'angle de champ.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Share of the picture that the DEM explains as ground</source>
        <translation>Part de l'image que le MNT explique comme terrain</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Ground shown with a probability of 0.9 or more (m²)</source>
        <translation>Terrain montré avec une probabilité d'au moins 0,9 (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Ground shown with a probability of 0.5 or more (m²)</source>
        <translation>Terrain montré avec une probabilité d'au moins 0,5 (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>elevation angle</source>
        <translation>angle de hauteur</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>height above the line of sight</source>
        <translation>hauteur au-dessus de la ligne de visée</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>column in the photograph</source>
        <translation>colonne dans la photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>row in the photograph</source>
        <translation>ligne dans la photo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>No layers and probabilities: the area has more than {count} million cells. Take a shorter maximum distance.</source>
        <translation>Ni couches ni probabilités : l'étendue a plus de {count} millions de cellules. Prenez une distance maximale plus courte.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>No probabilities: they need the area photo frame, with pitch and vertical field of view.</source>
        <translation>Pas de probabilités : il faut l'étendue cadre de la photo, avec le tangage et le champ vertical.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>probability that the photograph shows the cell</source>
        <translation>probabilité que la photo montre la cellule</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Farthest ground in view</source>
        <translation>Terrain visible le plus lointain</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>The polygon of {name} could not be built.</source>
        <translation>Le polygone de {name} n'a pas pu être construit.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Ground in view (m²)</source>
        <translation>Terrain visible (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Farthest ground in view (m)</source>
        <translation>Terrain visible le plus lointain (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Target height above ground (m)</source>
        <translation>Hauteur de la cible au-dessus du sol (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Height of the target; 0 means the ground itself.</source>
        <translation>Hauteur de la cible ; 0 désigne le sol lui-même.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Ground nearer than this does not count as seen, but it still hides the terrain behind it.</source>
        <translation>Le terrain plus proche ne compte pas comme vu, mais cache quand même le terrain derrière lui.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>The minimum distance must be smaller than the maximum distance.</source>
        <translation>La distance minimale doit être plus petite que la distance maximale.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: the heading is unknown.</source>
        <translation>Pas de bassin visuel : azimut de visée inconnu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: the horizontal field of view is unknown.</source>
        <translation>Pas de bassin visuel : angle de champ horizontal inconnu.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: a field of view must lie between 0 and 180 degrees.</source>
        <translation>Pas de bassin visuel : un angle de champ doit être compris entre 0 et 180 degrés.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Pitch or vertical field of view is unknown: the heading wedge is shown, not the photo's frame.</source>
        <translation>Le tangage ou l'angle de champ vertical est inconnu : c'est le secteur de visée qui est montré, pas le cadre de la photo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>Processes that work on different photographs at the same time, each with up to 700 MB of memory. 0: all cores but one, as far as memory allows. 1: no further process. The results are the same. If QGIS finds no Python interpreter to start, a warning says so and one process does the work.</source>
        <translation>Processus qui traitent en même temps des photographies différentes, chacun avec jusqu’à 700 Mo de mémoire. 0 : tous les cœurs sauf un, dans la limite de la mémoire. 1 : aucun processus supplémentaire. Les résultats sont les mêmes. Si QGIS ne trouve pas d’interpréteur Python à lancer, un avertissement l’indique et un seul processus fait le travail.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>Worker processes</source>
        <translation>Processus de travail</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>{count} processes share the work.</source>
        <translation>{count} processus se partagent le travail.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Simulate photos</source>
        <translation>Simuler des photos</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>render,view,panorama,synthetic,photo,preview,test data</source>
        <translation>rendu,vue,panorama,synthétique,photo,aperçu,données de test</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Realistic photographs of the terrain from points with a heading</source>
        <translation>Photographies réalistes du relief depuis des points munis d'un azimut de visée</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Renders sun, snow, haze, sky and clouds over the elevation model and writes real JPEG or HEIC files with position, compass heading and focal length, for planning photographs, for tests and for practice.</source>
        <translation>Calcule soleil, neige, brume, ciel et nuages au-dessus du modèle numérique de terrain et écrit de vrais fichiers JPEG ou HEIC avec position, azimut de boussole et focale, pour préparer des prises de vue, pour des tests et pour s'exercer.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Heading, pitch and roll come from fields (NULL: 0 for pitch and roll; points without a heading are skipped). The same seed gives the same pictures. The compass heading written is the exact one.</source>
        <translation>Azimut de visée, tangage et roulis viennent de champs (NULL : 0 pour tangage et roulis ; les points sans azimut sont ignorés). La même graine donne les mêmes images. L'azimut de boussole écrit est l'azimut exact.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Points with heading</source>
        <translation>Points avec azimut de visée</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Width (px)</source>
        <translation>Largeur (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Height (px)</source>
        <translation>Hauteur (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Size of the upright picture.</source>
        <translation>Taille de l'image redressée.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>HEIC needs the Python package pillow-heif.</source>
        <translation>HEIC exige le paquet Python pillow-heif.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Folder in which the pictures are saved.</source>
        <translation>Dossier dans lequel les images sont enregistrées.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>The point has no usable position or no heading.</source>
        <translation>Le point n'a pas de position utilisable ou pas d'azimut de visée.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>NULL: 65 degrees.</source>
        <translation>NULL : 65 degrés.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Clouds</source>
        <translation>Nuages</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>behind the ridge</source>
        <translation>derrière la crête</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>lid over the ridge</source>
        <translation>couvercle sur la crête</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>fog</source>
        <translation>brouillard</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>in the valley</source>
        <translation>dans la vallée</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Foreground</source>
        <translation>Premier plan</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>trees</source>
        <translation>arbres</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>people</source>
        <translation>personnes</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Degrees.</source>
        <translation>Degrés.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of the picture's width that is covered, 0 to 1.</source>
        <translation>Part de la largeur de l'image qui est couverte, 0 à 1.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Elevation. If this is empty, it is derived from the relief in view.</source>
        <translation>Altitude. Si ce champ est vide, elle est déduite du relief en vue.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>The same number gives the same picture.</source>
        <translation>Le même nombre donne la même image.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Weather of the scene.</source>
        <translation>Temps qu'il fait dans la scène.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of clouds</source>
        <translation>Part des nuages</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Objects near the camera.</source>
        <translation>Objets proches de l'appareil.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of foreground</source>
        <translation>Part du premier plan</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Azimuth of the sun (°)</source>
        <translation>Azimut du soleil (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Elevation of the sun (°)</source>
        <translation>Hauteur angulaire du soleil (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Visual range (m)</source>
        <translation>Visibilité (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Smaller values give more haze.</source>
        <translation>Des valeurs plus petites donnent plus de brume.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Terrain beyond is left out.</source>
        <translation>Le terrain au-delà est laissé de côté.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Snow line (m)</source>
        <translation>Limite de la neige (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Tree line (m)</source>
        <translation>Limite de la forêt (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Sensor noise</source>
        <translation>Bruit du capteur</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Standard deviation at mid-grey, in 8-bit steps.</source>
        <translation>Écart type à gris moyen, en pas de 8 bits.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Which photos show these places?</source>
        <translation>Quelles photos montrent ces lieux ?</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>search,photo,archive,place,visible,inverse,query,resolution,ranking</source>
        <translation>recherche,photo,archive,lieu,visible,inverse,requête,résolution,classement</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Table of places and the photos that show them: share, pixels per metre, angle, pixel, rank</source>
        <translation>Table des lieux et des photos qui les montrent : part, pixels par mètre, angle, pixel, rang</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Finds the photographs that show each point, line or area of the places layer. One row per place and photo gives the pixels per metre, the angle of incidence and the position in the picture. The best photo of each place comes first (&lt;b&gt;rank&lt;/b&gt; 1).</source>
        <translation>Trouve les photos qui montrent chaque point, ligne ou surface de la couche de lieux. Une ligne par lieu et photo donne les pixels par mètre, l'angle d'incidence et la position dans l'image. La meilleure photo de chaque lieu vient en premier (&lt;b&gt;rank&lt;/b&gt; 1).</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>&lt;b&gt;quality&lt;/b&gt; = visible share x pixels per metre x cosine of the angle of incidence: the pixels per metre of ground in the worse direction. &lt;b&gt;place_id&lt;/b&gt; and &lt;b&gt;photo_id&lt;/b&gt; are the features' ids, which you can use for relations to both layers.</source>
        <translation>&lt;b&gt;quality&lt;/b&gt; = part visible x pixels par mètre x cosinus de l'angle d'incidence : les pixels par mètre de sol dans la moins bonne direction. &lt;b&gt;place_id&lt;/b&gt; et &lt;b&gt;photo_id&lt;/b&gt; sont les identifiants des entités, que vous pouvez utiliser pour des relations avec les deux couches.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Points, lines or areas, in any coordinate system.</source>
        <translation>Points, lignes ou surfaces, dans tout système de coordonnées.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Copied to the table.</source>
        <translation>Copié dans la table.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Height of the target above the ground, for example of a tower or a tree top.</source>
        <translation>Hauteur de la cible au-dessus du sol, par exemple d'une tour ou d'une cime d'arbre.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Minimum visible share (%)</source>
        <translation>Part visible minimale (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photos that show less of a place are left out.</source>
        <translation>Les photos qui montrent moins d'un lieu sont laissées de côté.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photos of places</source>
        <translation>Photos des lieux</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>One row per place and photo that shows it, the best photo of each place first.</source>
        <translation>Une ligne par lieu et par photo qui le montre, la meilleure photo de chaque lieu en premier.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Number of rows</source>
        <translation>Nombre de lignes</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Number of places that no photo shows</source>
        <translation>Nombre de lieux qu'aucune photo ne montre</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>The places layer is empty, or lies outside the region for which the DEM's CRS is valid.</source>
        <translation>La couche de lieux est vide, ou se trouve hors de la région pour laquelle le SCR du MNT est valable.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Name of the place</source>
        <translation>Nom du lieu</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Rank among the photos of the place</source>
        <translation>Rang parmi les photos du lieu</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Visible share of the place</source>
        <translation>Part visible du lieu</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Share of the place within the frame</source>
        <translation>Part du lieu dans le cadre</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Column of its middle (px)</source>
        <translation>Colonne de son milieu (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Row of its middle (px)</source>
        <translation>Ligne de son milieu (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Azimuth from the camera (° from true north)</source>
        <translation>Azimut depuis l'appareil (° depuis le nord géographique)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Elevation angle from the camera (°)</source>
        <translation>Hauteur angulaire depuis l'appareil (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Pixels per metre</source>
        <translation>Pixels par mètre</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Quality: pixels per metre of ground in the worse direction</source>
        <translation>Qualité : pixels par mètre de sol dans la moins bonne direction</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <location filename="../panel/figures.py"/>
        <location filename="../panel/model/photo_layer.py"/>
        <source>Choose a layer of oriented photo points.</source>
        <translation>Choisissez une couche de points de photos orientées.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>There is no further photograph in this direction.</source>
        <translation>Il n'y a plus de photo dans ce sens.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>No photograph without a verdict follows.</source>
        <translation>Il ne reste plus loin aucune photo sans verdict.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>No viewshed yet: the photograph has no heading, or the elevation model is missing.</source>
        <translation>Pas encore de bassin visuel : la photo n'a pas d'azimut de visée, ou le modèle de terrain manque.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>Computing the viewshed ...</source>
        <translation>Calcul du bassin visuel ...</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>Opening {photo} ...</source>
        <translation>Ouverture de {photo} ...</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>The photograph cannot be shown.</source>
        <translation>La photo ne peut pas être affichée.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Nothing to turn yet: the picture or the elevation model is missing.</source>
        <translation>Rien à tourner pour l'instant : l'image ou le modèle de terrain manque.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Click a place on the map that the middle of the picture shows.</source>
        <translation>Cliquez sur la carte un lieu que montre le milieu de l'image.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>No landmark yet: the picture or the elevation model is missing.</source>
        <translation>Pas encore de point de repère : l'image ou le modèle de terrain manque.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Now click the same point on the map.</source>
        <translation>Cliquez maintenant le même point sur la carte.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>One landmark. Set another, press Snap, or press Keep.</source>
        <translation>Un point de repère. Posez-en un autre, appuyez sur Ajuster ou sur Conserver.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>{count} landmarks. Set another, press Snap, or press Keep.</source>
        <translation>{count} points de repère. Posez-en un autre, appuyez sur Ajuster ou sur Conserver.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>The landmarks contradict one another. Undo the last one, or check the pixels, the places on the map and the clock of the camera.</source>
        <translation>Les points de repère se contredisent. Annulez le dernier, ou vérifiez les pixels, les lieux sur la carte et l'horloge de l'appareil.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>The map's coordinate system does not reach there.</source>
        <translation>Le système de coordonnées de la carte ne va pas jusque-là.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Skyline drawn. Press Snap to fit the horizon to it.</source>
        <translation>Ligne d'horizon dessinée. Appuyez sur Ajuster pour y caler l'horizon.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Masked. Press Snap to fit the horizon without it.</source>
        <translation>Masqué. Appuyez sur Ajuster pour caler l'horizon sans cette partie.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>This needs a heading and an elevation model.</source>
        <translation>Il faut pour cela un azimut de visée et un modèle de terrain.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Drawn into the layer {layer}. Save its edits to keep it.</source>
        <translation>Dessiné dans la couche {layer}. Enregistrez ses modifications pour le garder.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Folder of landmarks, skylines and masks</source>
        <translation>Dossier des points de repère, lignes d'horizon et masques</translation>
    </message>
    <message>
        <location filename="../panel/layers.py"/>
        <source>The layer has no photographs.</source>
        <translation>La couche ne contient aucune photo.</translation>
    </message>
    <message>
        <location filename="../panel/layers.py"/>
        <source>The layer was removed. Choose another.</source>
        <translation>La couche a été supprimée. Choisissez-en une autre.</translation>
    </message>
    <message>
        <location filename="../panel/model/aids.py"/>
        <source>it is not JSON. Mend it, or delete it.</source>
        <translation>ce n'est pas du JSON valide. Réparez-le ou supprimez-le.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>This photograph has no answer {number}.</source>
        <translation>Cette photo n'a pas de réponse {number}.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Nothing to fit yet: the picture or the elevation model is missing.</source>
        <translation>Rien à ajuster pour l'instant : l'image ou le modèle de terrain manque.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Fitting ...</source>
        <translation>Ajustement ...</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Fitted: heading {heading}°. Press Keep to write it to the layer.</source>
        <translation>Ajusté : azimut {heading}°. Appuyez sur Conserver pour l'écrire dans la couche.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Nothing to keep yet: the photograph has no heading.</source>
        <translation>Rien à conserver pour l'instant : la photo n'a pas d'azimut de visée.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Kept in the layer's edit buffer. Save the layer's edits to make it permanent.</source>
        <translation>Conservé dans le tampon d'édition de la couche. Enregistrez les modifications de la couche pour le rendre permanent.</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>horizon moved</source>
        <translation>horizon déplacé</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>snapped to the skyline</source>
        <translation>calé sur la ligne d'horizon</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>another answer chosen</source>
        <translation>autre réponse choisie</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>placed by landmarks</source>
        <translation>placée par des points de repère</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>landmarks given</source>
        <translation>points de repère donnés</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>skyline drawn</source>
        <translation>ligne d'horizon dessinée</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>parts of the picture left out</source>
        <translation>parties de l'image exclues</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>confirmed by hand: the answer was right</source>
        <translation>confirmé à la main : la réponse était juste</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>corrected by hand: {how}</source>
        <translation>corrigé à la main : {how}</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Part of the figure shows the sky or lies beyond the elevation model, so it cannot be measured.</source>
        <translation>Une partie de la figure montre le ciel ou sort du modèle de terrain ; elle ne peut donc pas être mesurée.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Area on the map {area}, outline {length}.</source>
        <translation>Surface sur la carte {area}, contour {length}.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Distance on the map {length}, height difference {rise} m.</source>
        <translation>Distance sur la carte {length}, dénivelé {rise} m.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Points from photos</source>
        <translation>Points tirés des photos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Lines from photos</source>
        <translation>Lignes tirées des photos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Areas from photos</source>
        <translation>Surfaces tirées des photos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>This shows no ground that the elevation model knows, so nothing was drawn.</source>
        <translation>On ne voit ici aucun terrain connu du modèle de terrain ; rien n'a été dessiné.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>The layer {layer} cannot be edited.</source>
        <translation>La couche {layer} ne peut pas être modifiée.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Draw in a photo</source>
        <translation>Dessiner dans une photo</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Verdict of the review</source>
        <translation>Verdict de la revue</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The field {field} does not take the value. Check the layer's fields.</source>
        <translation>Le champ {field} n'accepte pas la valeur. Vérifiez les champs de la couche.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The layer {layer} is read-only. Export it as a GeoPackage, and correct the photographs there.</source>
        <translation>La couche {layer} est en lecture seule. Exportez-la en GeoPackage et corrigez-y les photos.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The layer takes no new fields ({fields}). Export it as a GeoPackage first.</source>
        <translation>La couche n'accepte pas de nouveaux champs ({fields}). Exportez-la d'abord en GeoPackage.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Correct {photo}</source>
        <translation>Corriger {photo}</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Review {photo}</source>
        <translation>Juger {photo}</translation>
    </message>
    <message>
        <location filename="../panel/model/faults.py"/>
        <source>An unexpected error occurred. Please report it and attach the log.</source>
        <translation>Une erreur inattendue s'est produite. Signalez-la en joignant le journal.</translation>
    </message>
    <message>
        <location filename="../panel/model/photo_layer.py"/>
        <source>The layer has no field with the photographs' paths. Choose the result of Orient photos.</source>
        <translation>La couche n'a pas de champ avec les chemins des photos. Choisissez le résultat d'Orienter des photos.</translation>
    </message>
    <message>
        <location filename="../panel/model/session.py"/>
        <source>The photograph is no longer in the layer.</source>
        <translation>La photo n'est plus dans la couche.</translation>
    </message>
    <message>
        <location filename="../panel/model/session.py"/>
        <source>Choose an elevation model to see the horizon.</source>
        <translation>Choisissez un modèle de terrain pour voir l'horizon.</translation>
    </message>
    <message>
        <location filename="../panel/model/solving.py"/>
        <source>The skyline contradicts the landmarks, so the horizon stays where they put it. Check the landmarks, or mask what hides the skyline.</source>
        <translation>La ligne d'horizon contredit les points de repère ; l'horizon reste où ils le placent. Vérifiez les points de repère, ou masquez ce qui cache la ligne d'horizon.</translation>
    </message>
    <message>
        <location filename="../panel/model/solving.py"/>
        <source>The skyline does not decide more exactly here, so the horizon stays where you put it. Set a landmark, draw the skyline, or mask what hides it.</source>
        <translation>La ligne d'horizon ne tranche pas plus finement ici ; l'horizon reste où vous l'avez mis. Posez un point de repère, dessinez la ligne d'horizon, ou masquez ce qui la cache.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The algorithm Directed viewshed is not there. Switch Processing on in the plugin manager.</source>
        <translation>L'algorithme Bassin visuel dirigé manque. Activez Processing dans le gestionnaire d'extensions.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The viewshed could not be computed. The log of Processing says why.</source>
        <translation>Le bassin visuel n'a pas pu être calculé. Le journal de Processing dit pourquoi.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>Viewshed of {photo}</source>
        <translation>Bassin visuel de {photo}</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The viewshed of {photo} is in the project.</source>
        <translation>Le bassin visuel de {photo} est dans le projet.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Previous</source>
        <translation>Précédente</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the previous photograph.</source>
        <translation>Montre la photo précédente.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Next</source>
        <translation>Suivante</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the next photograph.</source>
        <translation>Montre la photo suivante.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Next doubtful</source>
        <translation>Douteuse suivante</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the next photograph whose status is ambiguous, rejected or failed.</source>
        <translation>Montre la photo suivante dont le statut est ambiguous, rejected ou failed.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Look</source>
        <translation>Regarder</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Drag to pan, wheel to zoom, double click to see the whole picture.</source>
        <translation>Glissez pour déplacer, molette pour zoomer, double clic pour voir toute l'image.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Correct</source>
        <translation>Corriger</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Drag the horizon. The right button or Shift turns it, the wheel changes the field of view. Arrow keys, comma, full stop, plus and minus do the same.</source>
        <translation>Glissez l'horizon. Le bouton droit ou Maj le tourne, la molette change l'angle de champ. Les flèches, la virgule, le point, plus et moins font de même.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Landmark</source>
        <translation>Point de repère</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a point in the picture, then the same point on the map.</source>
        <translation>Cliquez un point de l'image, puis le même point sur la carte.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Sun</source>
        <translation>Soleil</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the sun in the picture. Its direction follows from the time and the place of the photograph.</source>
        <translation>Cliquez sur le Soleil dans l'image. Sa direction se déduit de l'heure et du lieu de la photographie.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Moon</source>
        <translation>Lune</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the moon in the picture. Its direction follows from the time and the place of the photograph.</source>
        <translation>Cliquez sur la Lune dans l'image. Sa direction se déduit de l'heure et du lieu de la photographie.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw skyline</source>
        <translation>Dessiner la ligne d'horizon</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw the whole skyline by hand; the extracted one is ignored.</source>
        <translation>Dessinez toute la ligne d'horizon à la main ; celle qui a été extraite est ignorée.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Repair skyline</source>
        <translation>Réparer la ligne d'horizon</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw over a wrong stretch of the extracted skyline.</source>
        <translation>Redessinez un tronçon faux de la ligne extraite.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Mask</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Brush over what hides the skyline: flags, clouds, people, trees.</source>
        <translation>Peignez ce qui cache la ligne d'horizon : drapeaux, nuages, personnes, arbres.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Measure distance</source>
        <translation>Mesurer une distance</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click points in the picture: distance and height difference on the ground.</source>
        <translation>Cliquez des points de l'image : distance et dénivelé sur le terrain.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Measure area</source>
        <translation>Mesurer une surface</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the corners of an area in the picture.</source>
        <translation>Cliquez les coins d'une surface de l'image.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw point</source>
        <translation>Dessiner un point</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a point in the picture; it goes to the active layer if that is edited, else to a new one.</source>
        <translation>Cliquez un point de l'image ; il va dans la couche active si elle est en édition, sinon dans une nouvelle.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw line</source>
        <translation>Dessiner une ligne</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a line in the picture. A double click, Enter or the right button ends it.</source>
        <translation>Cliquez une ligne dans l'image. Un double clic, Entrée ou le bouton droit la termine.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw area</source>
        <translation>Dessiner une surface</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click an area in the picture. A double click, Enter or the right button ends it.</source>
        <translation>Cliquez une surface dans l'image. Un double clic, Entrée ou le bouton droit la termine.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Face a place</source>
        <translation>Viser un lieu</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a place on the map: the camera turns to it.</source>
        <translation>Cliquez un lieu sur la carte : l'appareil se tourne vers lui.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Snap</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Fit the horizon to the picture from where it is.</source>
        <translation>Cale l'horizon sur l'image à partir de sa position actuelle.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Use alternative 2</source>
        <translation>Prendre l'alternative 2</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the second-best heading of the table, and fit from there.</source>
        <translation>Prend le deuxième meilleur azimut de la table et ajuste à partir de là.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Use alternative 3</source>
        <translation>Prendre l'alternative 3</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the third-best heading of the table, and fit from there.</source>
        <translation>Prend le troisième meilleur azimut de la table et ajuste à partir de là.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the last change back.</source>
        <translation>Annule la dernière modification.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Make the change again.</source>
        <translation>Refait la modification.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Write the correction to the layer's edit buffer, with the status confirmed.</source>
        <translation>Écrit la correction dans le tampon d'édition de la couche, avec le statut confirmed.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Compute the ground that this photograph shows, and add it as a layer.</source>
        <translation>Calcule le terrain que montre cette photo et l'ajoute comme couche.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Review</source>
        <translation>Revue</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Judge one photograph after the other with single keys.</source>
        <translation>Jugez une photo après l'autre avec une seule touche.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Accept</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>The answer is right.</source>
        <translation>La réponse est juste.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Reject</source>
        <translation>Rejeter</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>The answer is wrong.</source>
        <translation>La réponse est fausse.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Doubtful</source>
        <translation>Douteuse</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>It cannot be told.</source>
        <translation>On ne peut pas trancher.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Leave it for later.</source>
        <translation>La laisser pour plus tard.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Horizon of the elevation model</source>
        <translation>Horizon du modèle de terrain</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Crests below the horizon</source>
        <translation>Crêtes sous l'horizon</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Skyline in the picture</source>
        <translation>Ligne d'horizon dans l'image</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <location filename="../core/report/card.py"/>
        <source>Alternatives</source>
        <translation>Alternatives</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Azimuth and elevation angle</source>
        <translation>Azimut et angle d'élévation</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Map layers</source>
        <translation>Couches de la carte</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Page up</source>
        <translation>Page préc.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Page down</source>
        <translation>Page suiv.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <location filename="../panel/view/canvas.py"/>
        <source>Photograph</source>
        <translation>Photo</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Layer of oriented photo points.</source>
        <translation>Couche de points de photos orientées.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Elevation model</source>
        <translation>Modèle de terrain</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Choose what is drawn over the picture.</source>
        <translation>Choisissez ce qui est dessiné sur l'image.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Remove the landmarks</source>
        <translation>Retirer les points de repère</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Remove what was drawn and masked</source>
        <translation>Retirer ce qui a été dessiné et masqué</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Folder of landmarks, skylines and masks ...</source>
        <translation>Dossier des points de repère, lignes d'horizon et masques ...</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Show the whole picture</source>
        <translation>Montrer toute l'image</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Further commands for this photograph.</source>
        <translation>Autres commandes pour cette photo.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Reviewed photographs</source>
        <translation>Photos jugées</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>In the picture, {distance} away.</source>
        <translation>Dans l'image, à {distance}.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Hidden by terrain at {distance}.</source>
        <translation>Caché par le terrain à {distance}.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>The elevation model does not know this place.</source>
        <translation>Le modèle de terrain ne connaît pas ce lieu.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, straight ahead.</source>
        <translation>Hors de l'image, droit devant.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, {angle}° to the right of its middle.</source>
        <translation>Hors de l'image, {angle}° à droite de son milieu.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, {angle}° to the left of its middle.</source>
        <translation>Hors de l'image, {angle}° à gauche de son milieu.</translation>
    </message>
    <message>
        <location filename="../panel/view/strip.py"/>
        <source>Photographs of the layer</source>
        <translation>Photos de la couche</translation>
    </message>
    <message>
        <location filename="../panel/view/strip.py"/>
        <source>Click a photograph to show it.</source>
        <translation>Cliquez une photo pour la montrer.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>No photograph. Click a point on the map with the selection tool, or a thumbnail below.</source>
        <translation>Aucune photo. Cliquez un point de la carte avec l'outil de sélection, ou une vignette ci-dessous.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>heading {heading}°, pitch {pitch}°, roll {roll}°, field of view {hfov}°</source>
        <translation>azimut {heading}°, tangage {pitch}°, roulis {roll}°, angle de champ {hfov}°</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>no heading yet: press Snap, drag the horizon, or set a landmark</source>
        <translation>pas encore d'azimut de visée : appuyez sur Ajuster, glissez l'horizon ou posez un point de repère</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>the field of view is assumed</source>
        <translation>l'angle de champ est supposé</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>changed, not kept</source>
        <translation>modifiée, non conservée</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>azimuth {azimuth}°, elevation angle {angle}°</source>
        <translation>azimut {azimuth}°, angle d'élévation {angle}°</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>{elevation} m high, {distance} km away (90 %: {near} to {far} km), {direction}</source>
        <translation>{elevation} m d'altitude, à {distance} km (90 % : de {near} à {far} km), {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>Sky, {direction}</source>
        <translation>Ciel, {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>Beyond the elevation model or in a hole of it, {direction}</source>
        <translation>Hors du modèle de terrain ou dans une de ses lacunes, {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>The sun stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep.</source>
        <translation>Le Soleil se trouvait à l'azimut {azimuth}°, angle d'élévation {angle}°. Appuyez sur Ajuster ou sur Conserver.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>The moon stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep.</source>
        <translation>La Lune se trouvait à l'azimut {azimuth}°, angle d'élévation {angle}°. Appuyez sur Ajuster ou sur Conserver.</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>GPS altitude (m)</source>
        <translation>Altitude GPS (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading (°)</source>
        <translation>Azimut enregistré (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Rotation by EXIF (°)</source>
        <translation>Rotation selon EXIF (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Longitude (°)</source>
        <translation>Longitude (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Latitude (°)</source>
        <translation>Latitude (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Taken at (camera's local time)</source>
        <translation>Prise de vue (heure locale de l'appareil)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>35 mm equivalent focal length (mm)</source>
        <translation>Focale équivalente 35 mm (mm)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Width of the upright picture (px)</source>
        <translation>Largeur de l'image redressée (px)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Height of the upright picture (px)</source>
        <translation>Hauteur de l'image redressée (px)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading counts from (T true, M magnetic north)</source>
        <translation>Référence de l'azimut enregistré (T nord géographique, M nord magnétique)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>GPS horizontal error (m)</source>
        <translation>Erreur horizontale du GPS (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Camera</source>
        <translation>Appareil photo</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Correlation of skylines</source>
        <translation>Corrélation des lignes d'horizon</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Correlation of the second-best heading</source>
        <translation>Corrélation du deuxième meilleur azimut</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Second-best heading (°)</source>
        <translation>Deuxième meilleur azimut (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Third-best heading (°)</source>
        <translation>Troisième meilleur azimut (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Sharpness of the correlation peak</source>
        <translation>Netteté du pic de corrélation</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Heading, lower end of the 90 % interval (°)</source>
        <translation>Azimut de visée, borne inférieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Heading, upper end of the 90 % interval (°)</source>
        <translation>Azimut de visée, borne supérieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch, lower end of the 90 % interval (°)</source>
        <translation>Tangage, borne inférieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch, upper end of the 90 % interval (°)</source>
        <translation>Tangage, borne supérieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Roll, lower end of the 90 % interval (°)</source>
        <translation>Roulis, borne inférieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Roll, upper end of the 90 % interval (°)</source>
        <translation>Roulis, borne supérieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view, lower end of the 90 % interval (°)</source>
        <translation>Angle de champ horizontal, borne inférieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view, upper end of the 90 % interval (°)</source>
        <translation>Angle de champ horizontal, borne supérieure de l'intervalle à 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading (° from true north)</source>
        <translation>Azimut enregistré (° depuis le nord géographique)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded minus found heading (°)</source>
        <translation>Azimut enregistré moins azimut trouvé (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Grid convergence of the DEM (°)</source>
        <translation>Convergence des méridiens du MNT (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Distance of the horizon at the heading (m)</source>
        <translation>Distance de l'horizon dans l'azimut de visée (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Camera above the DEM (m), for Visibility Analysis</source>
        <translation>Appareil au-dessus du MNT (m), pour Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Search range (m), for Visibility Analysis</source>
        <translation>Portée de recherche (m), pour Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Left edge of view (° from grid north), for Visibility Analysis</source>
        <translation>Bord gauche de la vue (° depuis le nord du quadrillage), pour Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Right edge of view (° from grid north), for Visibility Analysis</source>
        <translation>Bord droit de la vue (° depuis le nord du quadrillage), pour Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/doubt.py"/>
        <source>The position is uncertain by {metres} m, which leaves the heading uncertain by more than 3 degrees. Correct the position.</source>
        <translation>La position est incertaine de {metres} m, ce qui laisse le cap incertain de plus de 3 degrés. Corrigez la position.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The photo {path} cannot be read: {reason}</source>
        <translation>La photo {path} ne peut pas être lue : {reason}</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>{reason} Use a photo that shows a mountain skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>{reason} Utilisez une photo qui montre une ligne d'horizon de montagnes, ou fournissez un masque de ciel ou une ligne d'horizon dessinée.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The position {latitude}, {longitude} (latitude, longitude) lies outside the DEM. Use a DEM that covers it, or correct the photo's coordinates.</source>
        <translation>La position {latitude}, {longitude} (latitude, longitude) se trouve hors du MNT. Utilisez un MNT qui la couvre, ou corrigez les coordonnées de la photo.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The DEM has no elevation (nodata) at {latitude}, {longitude} (latitude, longitude). Fill the void, use another DEM, or give the eye's elevation in HEIGHT_FIELD.</source>
        <translation>Le MNT n'a pas d'altitude (nodata) en {latitude}, {longitude} (latitude, longitude). Comblez la lacune, utilisez un autre MNT, ou donnez l'altitude de l'appareil dans HEIGHT_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The file {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>Le fichier {path} ne peut pas être écrit : {reason}. Choisissez un autre dossier ou libérez de l'espace.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The image features {path} cannot be read: {reason}</source>
        <translation>Les entités de l'image {path} ne peuvent pas être lues : {reason}</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The given elevation of the camera lies {metres} m below the DEM's surface, so the answer is not accepted. Check HEIGHT_FIELD, and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>L'altitude donnée de la caméra est {metres} m au-dessous de la surface du MNT, la réponse n'est donc pas acceptée. Vérifiez HEIGHT_FIELD et l'unité des altitudes du MNT (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface, more than GPS and DEM allow, so the answer is not accepted. Check the photo's position, and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>L'altitude enregistrée est {metres} m au-dessous de la surface du MNT, plus que le GPS et le MNT ne le permettent, la réponse n'est donc pas acceptée. Vérifiez la position de la photo et l'unité des altitudes du MNT (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface, more than GPS and DEM allow, so the answer is not accepted. Check the photo's position and the DEM; for a drone, set USE_ALTITUDE.</source>
        <translation>L'altitude enregistrée est {metres} m au-dessus de la surface du MNT, plus que le GPS et le MNT ne le permettent, la réponse n'est donc pas acceptée. Vérifiez la position de la photo et le MNT ; pour un drone, activez USE_ALTITUDE.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The skyline fits best from {metres} m above the DEM's surface, which was used.</source>
        <translation>La ligne d'horizon correspond le mieux depuis {metres} m au-dessus de la surface du MNT ; cette hauteur a été utilisée.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The skyline fits best from {metres} m below the DEM's surface, which was used.</source>
        <translation>La ligne d'horizon correspond le mieux depuis {metres} m au-dessous de la surface du MNT ; cette hauteur a été utilisée.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude refers to the ellipsoid, not to sea level; the DEM was used.</source>
        <translation>L'altitude enregistrée se rapporte à l'ellipsoïde et non au niveau de la mer ; le MNT a été utilisé.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface and was used.</source>
        <translation>L'altitude enregistrée est {metres} m au-dessus de la surface du MNT et a été utilisée.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface and was used.</source>
        <translation>L'altitude enregistrée est {metres} m au-dessous de la surface du MNT et a été utilisée.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface; the DEM was used.</source>
        <translation>L'altitude enregistrée est {metres} m au-dessus de la surface du MNT ; le MNT a été utilisé.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface; the DEM was used.</source>
        <translation>L'altitude enregistrée est {metres} m au-dessous de la surface du MNT ; le MNT a été utilisé.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if its heights were in {unit}. Set the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>Le MNT diffère de {metres} m (médiane de {count} photos) des altitudes enregistrées, comme si ses altitudes étaient en {unit}. Indiquez l'unité des altitudes du MNT (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if these were in feet. The program that wrote them is wrong; the DEM is used for the camera's elevation.</source>
        <translation>Le MNT diffère de {metres} m (médiane de {count} photos) des altitudes enregistrées, comme si celles-ci étaient en pieds. Le programme qui les a écrites se trompe ; le MNT sert pour l'altitude de la caméra.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, nearly the same everywhere, as if one of them counted from the ellipsoid or another vertical datum. Use a DEM with heights above sea level.</source>
        <translation>Le MNT diffère de {metres} m (médiane de {count} photos) des altitudes enregistrées, presque partout de la même valeur, comme si l'un des deux se rapportait à l'ellipsoïde ou à une autre référence verticale. Utilisez un MNT dont les altitudes sont au-dessus du niveau de la mer.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes. Check that the DEM holds heights, their unit (DEM_UNIT) and vertical datum, and the positions of the photos.</source>
        <translation>Le MNT diffère de {metres} m (médiane de {count} photos) des altitudes enregistrées. Vérifiez que le MNT contient des altitudes, leur unité (DEM_UNIT) et leur référence verticale, ainsi que les positions des photos.</translation>
    </message>
    <message>
        <location filename="../core/base/landmark_hint.py"/>
        <source>A landmark is the sun or the moon, but the photo does not record its time with a time zone. Write the tags DateTimeOriginal and OffsetTimeOriginal, or leave this landmark out.</source>
        <translation>Un repère est le Soleil ou la Lune, mais la photo n'enregistre pas son heure avec un fuseau horaire. Écrivez les balises DateTimeOriginal et OffsetTimeOriginal, ou laissez ce repère de côté.</translation>
    </message>
    <message>
        <location filename="../core/base/landmark_hint.py"/>
        <source>A landmark is the sun or the moon, which was below the horizon at {time}. Check the landmark and the clock of the camera.</source>
        <translation>Un repère est le Soleil ou la Lune, qui se trouvait sous l'horizon à {time}. Vérifiez le repère et l'horloge de l'appareil.</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>{feature} needs the Python package {package}. {hint}</source>
        <translation>{feature} exige le paquet Python {package}. {hint}</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>Run: {command} (or install your distribution's package)</source>
        <translation>Exécutez : {command} (ou installez le paquet de votre distribution)</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>In the OSGeo4W Shell run: {command}</source>
        <translation>Exécutez dans l'OSGeo4W Shell : {command}</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>Run: {command}</source>
        <translation>Exécutez : {command}</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The photo has no GPS position. Supply it as a point in a photo point layer.</source>
        <translation>La photo n'a pas de position GPS. Indiquez-la par un point dans une couche de points de photos.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The GPS position is uncertain by {km} km, too much for a horizon, so the right one is needed. Supply it as a point in a photo point layer.</source>
        <translation>La position GPS est incertaine de {km} km, trop pour un horizon ; il faut donc la bonne. Indiquez-la par un point dans une couche de points de photos.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The position is uncertain by {km} km (h_acc), so the result may hold for another place than the camera's. Move the point to where the camera was, and clear h_acc.</source>
        <translation>La position est incertaine de {km} km (h_acc) ; le résultat vaut donc peut-être pour un autre lieu que celui de la caméra. Déplacez le point là où était la caméra et videz h_acc.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The eye lies {metres} m below the DEM's surface, so the result is not what a camera sees. Check the camera's elevation (HEIGHT_FIELD), and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>L'œil est {metres} m au-dessous de la surface du MNT ; le résultat n'est donc pas ce que voit une caméra. Vérifiez l'altitude de la caméra (HEIGHT_FIELD) et l'unité des altitudes du MNT (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The eye lies {metres} m above the DEM's surface. Unless the camera flew so high, check its elevation (HEIGHT_FIELD), its height above the ground (EYE_HEIGHT), and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>L'œil est {metres} m au-dessus de la surface du MNT. Si la caméra n'a pas volé si haut, vérifiez son altitude (HEIGHT_FIELD), sa hauteur au-dessus du sol (EYE_HEIGHT) et l'unité des altitudes du MNT (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on the picture as it is stored; they were rotated with it.</source>
        <translation>Les entités ont été dessinées sur l'image telle qu'elle est enregistrée ; elles ont été tournées avec elle.</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on a copy of {width} x {height} pixels; they were scaled to the photo.</source>
        <translation>Les entités ont été dessinées sur une copie de {width} x {height} pixels ; elles ont été mises à l'échelle de la photo.</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on a picture of {width} x {height} pixels, which is no reduced copy of this photo of {photo_width} x {photo_height} pixels. Draw them on the photo itself.</source>
        <translation>Les entités ont été dessinées sur une image de {width} x {height} pixels, qui n'est pas une copie réduite de cette photo de {photo_width} x {photo_height} pixels. Dessinez-les sur la photo elle-même.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>In other photos of this run, the compass of this camera often contradicts the skyline, so its reading counts for less.</source>
        <translation>Sur d'autres photos de ce traitement, la boussole de cet appareil contredit souvent la ligne d'horizon ; son indication compte donc moins.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>The photo is a stitched panorama, which is not the picture of one lens. Use a single photo, or give the horizontal field of view in HFOV_FIELD if the panorama is rectilinear.</source>
        <translation>La photo est un panorama assemblé, qui n'est pas l'image d'un seul objectif. Utilisez une photo simple, ou donnez l'angle de champ horizontal dans HFOV_FIELD si le panorama est rectilinéaire.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>A lens with k1 = {k1} and k2 = {k2} would fold the picture before its corner. Correct k1 and k2: they are those of OpenCV, for radii in focal lengths.</source>
        <translation>Un objectif avec k1 = {k1} et k2 = {k2} replierait l'image avant son coin. Corrigez k1 et k2 : ce sont ceux d'OpenCV, pour des rayons en focales.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>The drawn skyline reaches beyond the picture of {width} x {height} pixels. Draw it on this picture, not on a reduced or turned copy.</source>
        <translation>La ligne d'horizon dessinée dépasse de l'image de {width} x {height} pixels. Dessinez-la sur cette image, et non sur une copie réduite ou tournée.</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>No place within {radius} m explains the skyline well. Check the field of view and the DEM, or search a larger area with Locate photos.</source>
        <translation>Aucun lieu à moins de {radius} m n'explique bien la ligne d'horizon. Vérifiez l'angle de champ et le MNT, ou cherchez dans une zone plus grande avec « Localiser les photos ».</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>The skyline fits from the recorded position about as well as from anywhere near it.</source>
        <translation>La ligne d'horizon convient depuis la position enregistrée à peu près aussi bien que depuis tout lieu proche.</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>The skyline fits much better {distance} m away, at azimuth {azimuth} degrees; the heading differs by {turn} degrees there. Check the recorded position, which was not changed.</source>
        <translation>La ligne d'horizon convient beaucoup mieux à {distance} m, à l'azimut {azimuth} degrés ; l'azimut y diffère de {turn} degrés. Vérifiez la position enregistrée, qui n'a pas été modifiée.</translation>
    </message>
    <message>
        <location filename="../core/figures/annotate.py"/>
        <source>annotated photograph</source>
        <translation>photo annotée</translation>
    </message>
    <message>
        <location filename="../core/figures/fonts.py"/>
        <source>Text in pictures needs a TrueType font, but none of DejaVu Sans, Arial, Liberation Sans or Helvetica is installed. Install one of them, for example with the package fonts-dejavu-core, or install a newer Pillow.</source>
        <translation>Le texte dans les images exige une police TrueType, mais ni DejaVu Sans, ni Arial, ni Liberation Sans, ni Helvetica n'est installée. Installez l'une d'elles, par exemple avec le paquet fonts-dejavu-core, ou installez un Pillow plus récent.</translation>
    </message>
    <message>
        <location filename="../core/figures/fonts.py"/>
        <location filename="../core/figures/raster.py"/>
        <source>Drawing and writing pictures</source>
        <translation>Le dessin et l'écriture d'images</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>view</source>
        <translation>vue</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>heading</source>
        <translation>azimut de visée</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>viewshed</source>
        <translation>bassin visuel</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>photograph</source>
        <translation>photographie</translation>
    </message>
    <message>
        <location filename="../core/figures/overlay.py"/>
        <location filename="../core/report/overview.py"/>
        <source>extracted skyline</source>
        <translation>ligne d'horizon extraite</translation>
    </message>
    <message>
        <location filename="../core/figures/overlay.py"/>
        <source>DEM horizon at {heading}</source>
        <translation>horizon du MNT à {heading}</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <location filename="../core/figures/score.py"/>
        <source>The DEM has no horizon here.</source>
        <translation>Le MNT n'a pas d'horizon ici.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Horizon of the DEM over all azimuths</source>
        <translation>Horizon du MNT sur tous les azimuts</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Image skyline against DEM horizon</source>
        <translation>Ligne d'horizon de l'image comparée à l'horizon du MNT</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>No column of the picture was compared with the DEM.</source>
        <translation>Aucune colonne de l'image n'a été comparée au MNT.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Skyline above DEM [px]</source>
        <translation>Ligne d'horizon au-dessus du MNT [px]</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Residuals along the columns: {words}.</source>
        <translation>Écarts le long des colonnes : {words}.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>no column compared</source>
        <translation>aucune colonne comparée</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>median {value}</source>
        <translation>médiane {value}</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>{share} % of the height</source>
        <translation>{share} % de la hauteur</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>{share} % of columns</source>
        <translation>{share} % des colonnes</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Elevation angle</source>
        <translation>Hauteur angulaire</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>cut by the DEM's edge</source>
        <translation>coupé par le bord du MNT</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>void</source>
        <translation>lacune</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>The horizon is highest at azimuth {azimuth}: its elevation angle there is {angle} degrees and its distance {distance}. The median elevation angle is {median} degrees. In {share} % of the directions the DEM ends before higher terrain can be ruled out.</source>
        <translation>L'horizon culmine à l'azimut {azimuth} : son angle d'élévation y est de {angle} degrés et sa distance de {distance}. L'angle d'élévation médian est de {median} degrés. Dans {share} % des directions, le MNT s'arrête avant qu'un terrain plus haut puisse être exclu.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Score over all headings</source>
        <translation>Score sur tous les azimuts</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>No heading was scored.</source>
        <translation>Aucun azimut n'a été évalué.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>compass</source>
        <translation>boussole</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>{score} over all headings</source>
        <translation>{score} sur tous les azimuts</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Score by direction, north up</source>
        <translation>Score par direction, nord en haut</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The probability is highest at azimuth {heading}: {share} %.</source>
        <translation>La probabilité est la plus grande à l'azimut {heading} : {share} %.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Probability of a unique answer by direction, north up</source>
        <translation>Probabilité d'une réponse unique par direction, nord en haut</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>No heading was found.</source>
        <translation>Aucun azimut n'a été trouvé.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The best heading is {heading} from true north.</source>
        <translation>Le meilleur azimut est {heading} depuis le nord géographique.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Alternatives are at {headings}.</source>
        <translation>Les alternatives sont à {headings}.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The compass recorded {heading}.</source>
        <translation>La boussole a enregistré {heading}.</translation>
    </message>
    <message>
        <location filename="../core/figures/stations.py"/>
        <source>{count} photographs within {extent} kilometres.</source>
        <translation>{count} photos dans un rayon de {extent} kilomètres.</translation>
    </message>
    <message>
        <location filename="../core/figures/stations.py"/>
        <location filename="../core/report/collection.py"/>
        <location filename="../core/report/report.py"/>
        <source>Camera positions and headings</source>
        <translation>Positions et azimuts de l'appareil</translation>
    </message>
    <message>
        <location filename="../core/figures/text.py"/>
        <source>N NNE NE ENE E ESE SE SSE S SSW SW WSW W WNW NW NNW</source>
        <translation>N NNE NE ENE E ESE SE SSE S SSO SO OSO O ONO NO NNO</translation>
    </message>
    <message>
        <location filename="../core/io/crs.py"/>
        <source>The coordinate reference system {crs} is not recognised. Assign a valid one.</source>
        <translation>Le système de coordonnées de référence {crs} n'est pas reconnu. Attribuez-en un valide.</translation>
    </message>
    <message>
        <location filename="../core/io/crs.py"/>
        <source>No transformation from {source} to {target} is available. Use a DEM in a common coordinate system.</source>
        <translation>Aucune transformation de {source} vers {target} n'est disponible. Utilisez un MNT dans un système de coordonnées courant.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} is a picture with a colour palette, not a raster of heights. Choose the elevation raster itself.</source>
        <translation>Le MNT {path} est une image à palette de couleurs, pas un raster d'altitudes. Choisissez le raster d'altitudes lui-même.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} has only 8 bits per cell, like a hillshade or another picture of the terrain. Choose the elevation raster itself; if these are heights, set their unit (DEM_UNIT).</source>
        <translation>Le MNT {path} n'a que 8 bits par cellule, comme un ombrage ou une autre image du terrain. Choisissez le raster d'altitudes lui-même ; si ce sont des altitudes, indiquez leur unité (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} holds heights encoded as colours (terrain-RGB, {name}). Decode them first with the raster calculator: {formula}, where R, G and B are the bands.</source>
        <translation>Le MNT {path} contient des altitudes codées en couleurs (terrain-RGB, {name}). Décodez-les d'abord avec la calculatrice raster : {formula}, où R, G et B sont les bandes.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} is a colour picture (red, green, blue), not a raster of heights. Choose the elevation raster itself.</source>
        <translation>Le MNT {path} est une image en couleurs (rouge, vert, bleu), pas un raster d'altitudes. Choisissez le raster d'altitudes lui-même.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>Band {band} of the DEM {path} has no valid cell. Choose another DEM.</source>
        <translation>La bande {band} du MNT {path} n'a aucune cellule valide. Choisissez un autre MNT.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} has values up to {highest}, which are no heights in metres: perhaps they are decimetres or centimetres. Set their unit (DEM_UNIT).</source>
        <translation>Le MNT {path} a des valeurs jusqu'à {highest}, qui ne sont pas des altitudes en mètres : peut-être des décimètres ou des centimètres. Indiquez leur unité (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The values of the DEM {path} lie between {low} and {high} and change from cell to cell like those of a hillshade, slope or aspect map, not like heights. Choose the elevation raster itself; if these are heights, set their unit (DEM_UNIT).</source>
        <translation>Les valeurs du MNT {path} vont de {low} à {high} et varient d'une cellule à l'autre comme celles d'un ombrage, d'une carte de pente ou d'exposition, pas comme des altitudes. Choisissez le raster d'altitudes lui-même ; si ce sont des altitudes, indiquez leur unité (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is larger than 200 MB. Split it by photograph.</source>
        <translation>il dépasse 200 Mo. Divisez-le par photo.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not UTF-8 text. Export it as JSON or CSV.</source>
        <translation>ce n'est pas du texte en UTF-8. Exportez-le en JSON ou CSV.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <location filename="../core/io/formats.py"/>
        <source>it cannot be opened ({reason}). Check the path and the permissions.</source>
        <translation>il ne peut pas être ouvert ({reason}). Vérifiez le chemin et les droits d'accès.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not valid JSON. Export it again.</source>
        <translation>ce n'est pas du JSON valide. Exportez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not in the format of LabelMe, COCO, VIA or GeoJSON. Export it in one of these formats, or as CSV with the columns photo, x and y.</source>
        <translation>il n'est pas au format LabelMe, COCO, VIA ou GeoJSON. Exportez-le dans l'un de ces formats, ou en CSV avec les colonnes photo, x et y.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>an entry is incomplete ({reason}). Export the file again.</source>
        <translation>une entrée est incomplète ({reason}). Exportez à nouveau le fichier.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it has no columns x and y (pixels). Name its columns photo, x and y.</source>
        <translation>il n'a pas de colonnes x et y (pixels). Nommez les colonnes photo, x et y.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>line {number} has no numbers for x and y. Correct that line.</source>
        <translation>la ligne {number} n'a pas de nombres pour x et y. Corrigez cette ligne.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>line {number} is incomplete ({reason}). Correct that line.</source>
        <translation>la ligne {number} est incomplète ({reason}). Corrigez cette ligne.</translation>
    </message>
    <message>
        <location filename="../core/io/folder.py"/>
        <source>The folder {folder} cannot be listed: {reason}. Check the path.</source>
        <translation>Le contenu du dossier {folder} ne peut pas être lu : {reason}. Vérifiez le chemin.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>the file is empty. Copy it again from its source.</source>
        <translation>le fichier est vide. Copiez-le à nouveau depuis sa source.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it ends too early or its directory is damaged. Copy it again from its source.</source>
        <translation>il finit trop tôt ou son répertoire est endommagé. Copiez-le à nouveau depuis sa source.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>its content is not a JPEG, HEIC, PNG, TIFF or WebP picture. Export it as JPEG.</source>
        <translation>son contenu n'est pas une image JPEG, HEIC, PNG, TIFF ou WebP. Exportez-la en JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it has no pixels. Copy it again from its source.</source>
        <translation>il n'a pas de pixels. Copiez-le à nouveau depuis sa source.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>its {width} x {height} pixels are more than {limit} megapixels. Reduce its size first.</source>
        <translation>ses {width} x {height} pixels dépassent {limit} mégapixels. Réduisez d'abord l'image.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it is a folder or a device, not a file. Check the path.</source>
        <translation>c'est un dossier ou un périphérique, pas un fichier. Vérifiez le chemin.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>there is no such file. Check the path.</source>
        <translation>ce fichier n'existe pas. Vérifiez le chemin.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} has {count} band(s), but no band {band}. Choose another.</source>
        <translation>Le MNT {path} a {count} bande(s), mais pas de bande {band}. Choisissez une autre bande.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>Band {band} of {path} contains complex numbers. Choose an elevation raster.</source>
        <translation>La bande {band} de {path} contient des nombres complexes. Choisissez un raster d'altitudes.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} has no geographic or projected coordinate reference system. Assign the right one (gdal_edit -a_srs).</source>
        <translation>Le MNT {path} n'a pas de système de coordonnées de référence géographique ou projeté. Attribuez-lui le bon (gdal_edit -a_srs).</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The coordinate reference system of the DEM {path} cannot be used. {reason}</source>
        <translation>Le système de coordonnées de référence du MNT {path} est inutilisable. {reason}</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} is not georeferenced. Warp it to a CRS first (gdalwarp).</source>
        <translation>Le MNT {path} n'est pas géoréférencé. Projetez-le d'abord dans un SCR (gdalwarp).</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} is rotated relative to its CRS. Warp it to a north-up grid first (gdalwarp).</source>
        <translation>Le MNT {path} est tourné par rapport à son SCR. Projetez-le d'abord sur une grille orientée au nord (gdalwarp).</translation>
    </message>
    <message>
        <location filename="../core/io/gpx.py"/>
        <source>The track {path} has no points. Choose a GPX file with a recorded track.</source>
        <translation>La trace {path} n’a pas de points. Choisissez un fichier GPX contenant une trace enregistrée.</translation>
    </message>
    <message>
        <location filename="../core/io/height_unit.py"/>
        <source>The values of the DEM are in {unit}, which is not a unit of height that is known here. Choose an elevation raster, or set the unit of its heights (DEM_UNIT).</source>
        <translation>Les valeurs du MNT sont en {unit}, qui n'est pas une unité d'altitude connue ici. Choisissez un raster d'altitudes, ou indiquez l'unité de ses altitudes (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/height_unit.py"/>
        <source>The unit of heights {unit} is not known. Give metres, feet, us-ft, dm, cm, km or a number of metres.</source>
        <translation>L'unité d'altitude {unit} n'est pas connue. Donnez metres, feet, us-ft, dm, cm, km ou un nombre de mètres.</translation>
    </message>
    <message>
        <location filename="../core/io/label_tools.py"/>
        <source>Shapes without an outline that can be read were left out: {kinds}.</source>
        <translation>Les formes sans contour lisible ont été omises : {kinds}.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The 35 mm equivalent was derived from the focal length and the focal plane resolution.</source>
        <translation>L'équivalent 35 mm a été déduit de la focale et de la résolution du plan focal.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The recorded 35 mm equivalent of {recorded} mm contradicts the recorded focal length and sensor, from which {derived} mm follows. If you know the horizontal field of view, give it in HFOV_FIELD.</source>
        <translation>L'équivalent 35 mm enregistré de {recorded} mm contredit la focale et le capteur enregistrés, qui donnent {derived} mm. Si vous connaissez l'angle de champ horizontal, donnez-le dans HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The picture is cropped: a 35 mm equivalent of {used} mm was used instead of {recorded} mm. If you know the horizontal field of view, give it in HFOV_FIELD.</source>
        <translation>L'image est recadrée : un équivalent 35 mm de {used} mm a été utilisé au lieu de {recorded} mm. Si vous connaissez l'angle de champ horizontal, donnez-le dans HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>No lens has the recorded 35 mm equivalent of {recorded} mm; it was ignored.</source>
        <translation>Aucun objectif n'a l'équivalent 35 mm enregistré de {recorded} mm ; il a été ignoré.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The recorded 35 mm equivalent leaves out the digital zoom: {used} mm was used instead of {recorded} mm.</source>
        <translation>L'équivalent 35 mm enregistré ne tient pas compte du zoom numérique : {used} mm a été utilisé au lieu de {recorded} mm.</translation>
    </message>
    <message>
        <location filename="../core/io/local_copy.py"/>
        <source>the file cannot be opened</source>
        <translation>le fichier ne peut pas être ouvert</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates are not numbers (no GPS fix) and were ignored.</source>
        <translation>Les coordonnées enregistrées ne sont pas des nombres (pas de signal GPS) et ont été ignorées.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates lie outside the range of latitude and longitude and were ignored.</source>
        <translation>Les coordonnées enregistrées sont hors des limites de latitude et de longitude et ont été ignorées.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates are 0, 0 (no GPS fix) and were ignored.</source>
        <translation>Les coordonnées enregistrées sont 0, 0 (pas de signal GPS) et ont été ignorées.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The hemisphere is not recorded; north and east were assumed where it is missing.</source>
        <translation>L'hémisphère n'est pas enregistré ; là où il manque, nord et est ont été supposés.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The GPS had no fix when the photo was taken, so the position may be that of another place.</source>
        <translation>Le GPS ne captait pas lors de la prise de vue ; la position peut donc être celle d'un autre lieu.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The GPS position is imprecise (DOP {dop}): an error of {metres} m was assumed.</source>
        <translation>La position GPS est imprécise (DOP {dop}) : une erreur de {metres} m a été supposée.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The picture is a panorama of {angle} degrees, not that of one lens; its field of view is unknown.</source>
        <translation>L'image est un panorama de {angle} degrés, pas celle d'un seul objectif ; son angle de champ est inconnu.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The picture is a panorama, not that of one lens; its field of view is unknown.</source>
        <translation>L'image est un panorama, pas celle d'un seul objectif ; son angle de champ est inconnu.</translation>
    </message>
    <message>
        <location filename="../core/io/osm_summits.py"/>
        <source>The OpenStreetMap extract {path} cannot be read: {reason}. Download it again.</source>
        <translation>L'extrait d'OpenStreetMap {path} ne peut pas être lu : {reason}. Téléchargez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../core/io/osm_summits.py"/>
        <source>it has another format</source>
        <translation>il a un autre format</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>it is damaged or incomplete. Copy it again from its source.</source>
        <translation>il est endommagé ou incomplet. Copiez-le à nouveau depuis sa source.</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>it is too large for this computer's memory. Reduce its size.</source>
        <translation>elle est trop grande pour la mémoire de cet ordinateur. Réduisez l'image.</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>HEIC needs the Python package pillow-heif. {hint}, or export it as JPEG.</source>
        <translation>HEIC exige le paquet Python pillow-heif. {hint}, ou exportez la photo en JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} does not exist. Check the path.</source>
        <translation>Le MNT {path} n'existe pas. Vérifiez le chemin.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} is not a raster that GDAL can read. Choose an elevation raster.</source>
        <translation>Le MNT {path} n'est pas un raster que GDAL sait lire. Choisissez un raster d'altitudes.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} is damaged ({reason}). Copy it again.</source>
        <translation>Le MNT {path} est endommagé ({reason}). Copiez-le à nouveau.</translation>
    </message>
    <message>
        <location filename="../core/io/report_file.py"/>
        <location filename="../core/io/whole_file.py"/>
        <location filename="../core/io/write_raster.py"/>
        <source>the folder {folder} does not exist</source>
        <translation>le dossier {folder} n'existe pas</translation>
    </message>
    <message>
        <location filename="../core/io/report_file.py"/>
        <source>The report {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>Le rapport {path} ne peut pas être écrit : {reason}. Choisissez un autre dossier ou libérez de l'espace.</translation>
    </message>
    <message>
        <location filename="../core/io/tiff_pages.py"/>
        <source>it is a raw file of a camera, which must be exported as JPEG first.</source>
        <translation>c'est un fichier brut (RAW) d'appareil photo, qui doit d'abord être exporté en JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/tiff_pages.py"/>
        <source>its first page of {width} x {height} pixels is a thumbnail of a larger picture. Export that as JPEG.</source>
        <translation>sa première page de {width} x {height} pixels est une vignette d'une image plus grande. Exportez celle-ci en JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>The photo {path} cannot be written: its name must end in .jpg or .heic.</source>
        <translation>La photo {path} ne peut pas être écrite : son nom doit se terminer par .jpg ou .heic.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>Writing HEIC photographs</source>
        <translation>L'écriture de photos HEIC</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>The photo {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>La photo {path} ne peut pas être écrite : {reason}. Choisissez un autre dossier ou libérez de la place.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>Writing photographs</source>
        <translation>L'écriture de photos</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>cannot be created</source>
        <translation>il ne peut pas être créé</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>the folder {folder} is read-only</source>
        <translation>le dossier {folder} est en lecture seule</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>the disk may be full</source>
        <translation>le disque est peut-être plein</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The photos taken nearby decide the heading: no other heading fits all of them.</source>
        <translation>Les photos prises à proximité décident de l'azimut de visée : aucun autre ne convient à toutes.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>Photos taken nearby contradict this heading. Compare the overlays, or give an approximate heading or a landmark.</source>
        <translation>Des photos prises à proximité contredisent cet azimut. Comparez les superpositions, ou donnez un azimut approché ou un point de repère.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The photos taken nearby suggest this heading but do not decide it. Check the overlay, or give an approximate heading or a landmark.</source>
        <translation>Les photos prises à proximité suggèrent cet azimut sans en décider. Vérifiez la superposition, ou donnez un azimut approché ou un point de repère.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>Features that it shares with {photos} helped to find the heading.</source>
        <translation>Les points communs avec {photos} ont aidé à trouver l'azimut de visée.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The error of the compass that it shares with {count} photos of the same hour (such as {photo}) helped to find the heading.</source>
        <translation>L'erreur de la boussole, commune à {count} photos de la même heure (comme {photo}), a aidé à trouver l'azimut de visée.</translation>
    </message>
    <message>
        <location filename="../core/locate/build.py"/>
        <source>The DEM has no heights in the area. Choose another area, or a DEM without voids there.</source>
        <translation>Le MNT n'a pas d'altitudes dans la zone. Choisissez une autre zone, ou un MNT sans lacunes à cet endroit.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>From this place, the DEM horizon matches the skyline in {share} % of the columns; no place elsewhere in the area scores close.</source>
        <translation>De ce lieu, l'horizon du MNT coïncide avec la ligne d'horizon dans {share} % des colonnes ; aucun lieu ailleurs dans la zone ne s'en approche.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>No place in the area fits the skyline clearly. The photo was probably not taken in this area, or clouds, trees or a narrow view hide what would decide it. Choose another area, or give a sky mask or the field of view.</source>
        <translation>Aucun lieu de la zone ne convient clairement à la ligne d'horizon. La photo n'a probablement pas été prise dans cette zone, ou des nuages, des arbres ou une vue étroite cachent ce qui déciderait. Choisissez une autre zone, ou donnez un masque du ciel ou l'angle de champ.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>This place fits best, but others in the area fit nearly as well, or the fit is weak. Compare the candidates, or choose a smaller area.</source>
        <translation>Ce lieu convient le mieux, mais d'autres dans la zone conviennent presque aussi bien, ou l'ajustement est faible. Comparez les candidats, ou choisissez une zone plus petite.</translation>
    </message>
    <message>
        <location filename="../core/locate/places.py"/>
        <source>The area needs an index of {needed} MB, and {limit} MB are allowed. Choose an area of at most {km2} km2, a wider spacing of the places, or a folder for the index, which then stays on disk.</source>
        <translation>La zone demande un index de {needed} Mo, et {limit} Mo sont permis. Choisissez une zone d'au plus {km2} km2, un plus grand espacement des lieux, ou un dossier pour l'index, qui reste alors sur le disque.</translation>
    </message>
    <message>
        <location filename="../core/locate/places.py"/>
        <source>No part of the area lies inside the DEM. Choose an area that the DEM covers, or another DEM.</source>
        <translation>Aucune partie de la zone ne se trouve dans le MNT. Choisissez une zone que le MNT couvre, ou un autre MNT.</translation>
    </message>
    <message>
        <location filename="../core/locating.py"/>
        <source>Hardly any column of the picture shows a boundary between sky and terrain.</source>
        <translation>Presque aucune colonne de l'image ne montre une limite entre ciel et terrain.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>At the landmark's heading the DEM horizon does not follow the skyline that was found in the picture. Check the landmark and the overlay, or give a second landmark, a sky mask or a drawn skyline.</source>
        <translation>À l'azimut donné par le point de repère, l'horizon du MNT ne suit pas la ligne d'horizon trouvée dans l'image. Vérifiez le point de repère et la superposition, ou donnez un deuxième point de repère, un masque du ciel ou une ligne d'horizon dessinée.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies outside the picture of {width} x {height} pixels and was not used. Check that its pixel belongs to this picture, and not to a reduced or turned copy.</source>
        <translation>Le point de repère {number} est hors de l'image de {width} x {height} pixels et n'a pas été utilisé. Vérifiez que son pixel appartient à cette image et non à une copie réduite ou tournée.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} contradicts the picture, in which the skyline alone decides the heading: its map point lies {count} degrees in azimuth from its pixel. It was not used. Check the pixel and the map point.</source>
        <translation>Le point de repère {number} contredit l'image, dans laquelle la ligne d'horizon suffit à déterminer l'azimut de visée : son point sur la carte s'écarte de {count} degrés en azimut de son pixel. Il n'a pas été utilisé. Vérifiez le pixel et le point sur la carte.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies {count} pixels from its predicted position.</source>
        <translation>Le point de repère {number} se trouve à {count} pixels de sa position prévue.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies outside the view, {count} degrees in azimuth from the heading. Check the landmark and the position.</source>
        <translation>Le point de repère {number} est hors du champ, son azimut s'écarte de {count} degrés de celui de la prise de vue. Vérifiez le point de repère et la position.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The skyline does not decide the heading, so the approximate heading is given back. Check the overlay, or give a landmark, a drawn skyline or a sky mask.</source>
        <translation>La ligne d'horizon ne détermine pas l'azimut ; l'azimut approximatif est donc repris. Vérifiez la superposition, ou indiquez un point de repère, une ligne d'horizon dessinée ou un masque de ciel.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The mirror image of the photo fits the DEM better than the photo itself. If it was flipped (a slide scanned from the wrong side), flip it back and run again; else check the overlay.</source>
        <translation>L'image miroir de la photo correspond mieux au MNT que la photo elle-même. Si elle est inversée (une diapositive numérisée du mauvais côté), retournez-la et relancez ; sinon, vérifiez la superposition.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>According to the DEM, the most distinct line in the picture is a nearby crest; the fainter line behind it was used as the skyline.</source>
        <translation>D'après le MNT, la ligne la plus nette de l'image est une crête proche ; la ligne plus faible derrière elle a été utilisée comme ligne d'horizon.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>Hardly any column of the picture shows a boundary between sky and terrain. Use a photo with a skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>Presque aucune colonne de l'image ne montre de limite entre ciel et terrain. Utilisez une photo avec une ligne d'horizon, ou fournissez un masque de ciel ou une ligne d'horizon dessinée.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The DEM has no terrain around this position. Use a DEM that reaches farther.</source>
        <translation>Le MNT n'a pas de terrain autour de cette position. Utilisez un MNT qui va plus loin.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>In {share} % of the frame the DEM ends or has voids before higher terrain can be ruled out. Use a larger DEM to make the heading more certain.</source>
        <translation>Dans {share} % de l'image, le MNT s'arrête ou a des lacunes avant qu'un terrain plus haut puisse être exclu. Utilisez un MNT plus étendu pour rendre l'azimut plus sûr.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The photo's compass says {heading} degrees and took no part. If you trust it, use it as a hint (COMPASS).</source>
        <translation>La boussole de la photo indique {heading} degrés et n'a pas été prise en compte. Si vous lui faites confiance, utilisez-la comme indice (COMPASS).</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The horizon is almost straight here, so it fits many headings. Give an approximate heading or a landmark.</source>
        <translation>L'horizon est ici presque droit et convient à beaucoup d'azimuts. Donnez un azimut approché ou un point de repère.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The DEM horizon matches the skyline in {share} % of the columns; no other heading scores close.</source>
        <translation>L'horizon du MNT coïncide avec la ligne d'horizon dans {share} % des colonnes ; aucun autre azimut n'obtient un score proche.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>No heading fits the skyline. Check the position and the field of view, or give a sky mask, a drawn skyline, a landmark or an approximate heading.</source>
        <translation>Aucun azimut ne correspond à la ligne d'horizon. Vérifiez la position et l'angle de champ, ou donnez un masque de ciel, une ligne d'horizon dessinée, un point de repère ou un azimut approché.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>A heading of {heading} degrees fits nearly as well. Compare the overlays, or give an approximate heading or a landmark.</source>
        <translation>Un azimut de {heading} degrés convient presque aussi bien. Comparez les superpositions, ou donnez un azimut approché ou un point de repère.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The fit is weak. Check the overlay, or give an approximate heading, a landmark or a sky mask.</source>
        <translation>L'ajustement est faible. Vérifiez la superposition, ou donnez un azimut approché, un point de repère ou un masque de ciel.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The DEM horizon does not follow the skyline that was found in the picture. Check the overlay, or give a sky mask, a drawn skyline or an approximate heading.</source>
        <translation>L'horizon du MNT ne suit pas la ligne d'horizon trouvée dans l'image. Vérifiez la superposition, ou indiquez un masque du ciel, une ligne d'horizon dessinée ou un azimut approximatif.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The photo's compass says {heading} degrees, which contradicts the heading found. Check the overlay, use the compass as a hint (COMPASS), or give an approximate heading.</source>
        <translation>La boussole de la photo indique {heading} degrés, ce qui contredit l'azimut trouvé. Vérifiez la superposition, utilisez la boussole comme indice (COMPASS) ou indiquez un azimut approximatif.</translation>
    </message>
    <message>
        <location filename="../core/match/prior.py"/>
        <source>The photo has no focal length (35 mm equivalent). Give the horizontal field of view in HFOV_FIELD.</source>
        <translation>La photo n'a pas de focale (équivalente 35 mm). Donnez l'angle de champ horizontal dans HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>The skyline or the DEM's horizon is a straight line, which cannot be matched. Use a photo that shows a mountain skyline.</source>
        <translation>La ligne d'horizon ou l'horizon du MNT est une droite, qui ne peut pas être appariée. Utilisez une photo qui montre une ligne d'horizon de montagnes.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>The paper method does not test its result. Check the overlay, or use the robust method.</source>
        <translation>La méthode de l'article ne vérifie pas son résultat. Vérifiez la superposition, ou utilisez la méthode robuste.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>A skyline was found in only {share} % of the columns. Use a photo that shows more of the skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>Une ligne d'horizon n'a été trouvée que dans {share} % des colonnes. Utilisez une photo qui en montre davantage, ou fournissez un masque de ciel ou une ligne d'horizon dessinée.</translation>
    </message>
    <message>
        <location filename="../core/paper/skyline.py"/>
        <source>The picture has no smooth region above a rough one.</source>
        <translation>L'image n'a pas de zone lisse au-dessus d'une zone rugueuse.</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>best guess</source>
        <translation>meilleure estimation</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>most likely of several</source>
        <translation>le plus probable de plusieurs</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Pitch</source>
        <translation>Tangage</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Roll</source>
        <translation>Roulis</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>HFOV</source>
        <translation>Champ hor.</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Compass − found</source>
        <translation>Boussole − trouvé</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Eye elevation</source>
        <translation>Altitude de l'œil</translation>
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
        <translation>probabilité</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>{chance} within 3°</source>
        <translation>{chance} à moins de 3°</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>picture with extracted skyline and DEM horizons</source>
        <translation>image avec la ligne d'horizon extraite et les horizons du MNT</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>extracted</source>
        <translation>extraite</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>DEM at {heading}</source>
        <translation>MNT à {heading}</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>alternatives</source>
        <translation>alternatives</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>Camera heading and visible ground</source>
        <translation>Azimut de l'appareil et terrain visible</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>All numbers and the DEM horizon</source>
        <translation>Tous les chiffres et l'horizon du MNT</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>All numbers</source>
        <translation>Tous les chiffres</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>All photographs</source>
        <translation>Toutes les photos</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Previous page</source>
        <translation>Page précédente</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Next page</source>
        <translation>Page suivante</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>photographs {first} to {last}</source>
        <translation>photos {first} à {last}</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>whole map</source>
        <translation>carte entière</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>only this section of the map</source>
        <translation>cette partie de la carte seulement</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Search names, cameras, dates and reasons</source>
        <translation>Chercher noms, appareils, dates et raisons</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Pages of cards</source>
        <translation>Pages de fiches</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>{count} of {all} photographs</source>
        <translation>{count} photos sur {all}</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>{first} to {last}</source>
        <translation>{first} à {last}</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Recorded heading minus heading found, of accepted and confirmed photographs. Bias is the median with its 90 % interval, spread is robust; both leave out readings farther than {limit} from the others.</source>
        <translation>Azimut enregistré moins azimut trouvé des photos acceptées et confirmées. Le biais est la médiane avec son intervalle à 90 %, la dispersion est robuste ; les deux omettent les lectures qui s’écartent de plus de {limit} des autres.</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Compasses</source>
        <translation>Boussoles</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Bias</source>
        <translation>Biais</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Spread</source>
        <translation>Dispersion</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Off by more than 30°</source>
        <translation>Écart de plus de 30°</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Near +90°, −90°, 180°</source>
        <translation>Près de +90°, −90°, 180°</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Drift per hour</source>
        <translation>Dérive par heure</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>(turned)</source>
        <translation>(tournée)</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <location filename="../core/report/facts.py"/>
        <source>{low} to {high}</source>
        <translation>{low} à {high}</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>failed</source>
        <translation>en échec</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Other values</source>
        <translation>Autres valeurs</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Lens</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Compass</source>
        <translation>Boussole</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Position and elevation</source>
        <translation>Position et altitude</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>DEM horizon</source>
        <translation>Horizon du MNT</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Heading, true</source>
        <translation>Azimut, géographique</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>90 % interval</source>
        <translation>Intervalle à 90 %</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pitch, + up</source>
        <translation>Tangage, + vers le haut</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Roll, + right side down</source>
        <translation>Roulis, + côté droit vers le bas</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Alternative {rank}</source>
        <translation>Alternative {rank}</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Within 3° of the truth</source>
        <translation>À moins de 3° de la vérité</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Score of alternative 2</source>
        <translation>Score de l'alternative 2</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>NCC of the second peak</source>
        <translation>NCC du deuxième pic</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Sharpness of the peak</source>
        <translation>Netteté du pic</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Residual, median</source>
        <translation>Écart, médiane</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Columns compared</source>
        <translation>Colonnes comparées</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Horizontal field of view</source>
        <translation>Angle de champ horizontal</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Vertical field of view</source>
        <translation>Angle de champ vertical</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Focal length</source>
        <translation>Distance focale</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>35 mm equivalent, used</source>
        <translation>Équivalent 35 mm, utilisé</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>35 mm equivalent, EXIF</source>
        <translation>Équivalent 35 mm, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distortion k1, k2</source>
        <translation>Distorsion k1, k2</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>from true north</source>
        <translation>depuis le nord géographique</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>from magnetic north</source>
        <translation>depuis le nord magnétique</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>reference unknown</source>
        <translation>référence inconnue</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Converted to true north</source>
        <translation>Converti au nord géographique</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Recorded minus found</source>
        <translation>Enregistré moins trouvé</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pitch of the gimbal, + up</source>
        <translation>Tangage de la nacelle, + vers le haut</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Roll of the gimbal, + right side down</source>
        <translation>Roulis de la nacelle, + côté droit vers le bas</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Position error, EXIF</source>
        <translation>Erreur de position, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Eye elevation, used</source>
        <translation>Altitude de l'œil, utilisée</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>DEM under the eye</source>
        <translation>MNT sous l'œil</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Eye above the DEM</source>
        <translation>Œil au-dessus du MNT</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Altitude, EXIF</source>
        <translation>Altitude, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>sea level</source>
        <translation>niveau de la mer</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>below sea level</source>
        <translation>sous le niveau de la mer</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>ellipsoid</source>
        <translation>ellipsoïde</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distance in view, median</source>
        <translation>Distance visible, médiane</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distance in view, farthest</source>
        <translation>Distance visible, maximale</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Cut by the DEM's edge in view</source>
        <translation>Coupé par le bord du MNT dans la vue</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Cell size</source>
        <translation>Taille de cellule</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Grid north from true north</source>
        <translation>Nord de la grille depuis le nord géographique</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Path</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Size, upright</source>
        <translation>Taille, redressée</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Taken, camera's time</source>
        <translation>Prise, heure de l'appareil</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Place and horizon</source>
        <translation>Lieu et horizon</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Eye and DEM</source>
        <translation>Œil et MNT</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>1 place</source>
        <translation>1 lieu</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>{count} places</source>
        <translation>{count} lieux</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Highest horizon</source>
        <translation>Horizon le plus haut</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>at azimuth</source>
        <translation>à l'azimut</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Mean horizon</source>
        <translation>Horizon moyen</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Median distance</source>
        <translation>Distance médiane</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Farthest</source>
        <translation>Le plus loin</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Cut by DEM edge</source>
        <translation>Coupé par le bord du MNT</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Void</source>
        <translation>Lacune</translation>
    </message>
    <message>
        <location filename="../core/report/orientability.py"/>
        <source>Expected error of the heading</source>
        <translation>Erreur attendue de l'azimut</translation>
    </message>
    <message>
        <location filename="../core/report/orientability.py"/>
        <source>Field of view {hfov}°</source>
        <translation>Angle de champ {hfov}°</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Heading</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Within 3°</source>
        <translation>À moins de 3°</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Second best</source>
        <translation>Deuxième meilleur</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Residual</source>
        <translation>Écart</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>all</source>
        <translation>toutes</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>evidence</source>
        <translation>indices</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>DEM horizon, answer</source>
        <translation>horizon du MNT, réponse</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>whole picture</source>
        <translation>image entière</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Run</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Parameters, DEM and software</source>
        <translation>Paramètres, MNT et logiciel</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>language code: en</source>
        <translation>code de langue : fr</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Made by {software}.</source>
        <translation>Réalisé par {software}.</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>The cards are in the folder {folder} beside this page: keep both together. They load nothing from the network.</source>
        <translation>Les fiches se trouvent dans le dossier {folder} à côté de cette page : gardez les deux ensemble. Rien n’est chargé depuis le réseau.</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>This page is self-contained and loads nothing from the network. Keys: j for the next photo, k for the previous one.</source>
        <translation>Cette page est autonome et ne charge rien depuis le réseau. Touches : j pour la photo suivante, k pour la précédente.</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>Compass minus heading found</source>
        <translation>Boussole moins azimut trouvé</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>{count} readings, median difference {median}.</source>
        <translation>{count} lectures, écart médian {median}.</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>hour of the day, camera's clock</source>
        <translation>heure du jour, horloge de l’appareil</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>most in one bar: {count}</source>
        <translation>barre la plus haute : {count}</translation>
    </message>
    <message>
        <location filename="../core/skyline/evidence.py"/>
        <source>The picture has a single colour.</source>
        <translation>L'image n'a qu'une couleur.</translation>
    </message>
    <message>
        <location filename="../core/skyline/evidence.py"/>
        <source>The picture is only {width} x {height} pixels.</source>
        <translation>L'image n'a que {width} x {height} pixels.</translation>
    </message>
    <message>
        <location filename="../core/skyline/given.py"/>
        <source>The drawn skyline has fewer than two points.</source>
        <translation>La ligne d'horizon dessinée a moins de deux points.</translation>
    </message>
    <message>
        <location filename="../core/skyline/given.py"/>
        <source>The supplied skyline or sky mask has no change from sky to terrain.</source>
        <translation>La ligne d'horizon ou le masque de ciel fourni n'a pas de passage du ciel au terrain.</translation>
    </message>
    <message>
        <location filename="../core/skyline/plausible.py"/>
        <source>The picture shows no skyline: no line separates sky from terrain.</source>
        <translation>L'image ne montre aucune ligne d'horizon : aucune ligne ne sépare le ciel du terrain.</translation>
    </message>
    <message>
        <location filename="../core/skyline/plausible.py"/>
        <source>The picture shows no mountain skyline: its lines are level and upright, as in a room or on a page.</source>
        <translation>L'image ne montre aucune ligne de montagnes : ses lignes sont horizontales et verticales, comme dans une pièce ou sur une page.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The clock cannot be determined: only {count} photos with a time, at least a minute apart, show a skyline, and {least} are needed. Give the clock's offset.</source>
        <translation>L’horloge ne peut pas être déterminée : seules {count} photos datées, espacées d’au moins une minute, montrent une ligne d’horizon, il en faut {least}. Indiquez le décalage de l’horloge.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The clock cannot be determined from the skylines: other offsets fit as well. Give the clock's offset, or more photos with a clear skyline from different places.</source>
        <translation>L’horloge ne peut pas être déterminée d’après les lignes d’horizon : d’autres décalages conviennent aussi bien. Indiquez le décalage de l’horloge, ou ajoutez des photos avec une ligne d’horizon nette prises de lieux différents.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The camera's clock is ahead by {offset} s (90 % interval: {lo} to {hi} s); {count} photos agree.</source>
        <translation>L’horloge de l’appareil avance de {offset} s (intervalle à 90 % : de {lo} à {hi} s) ; {count} photos concordent.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The track has fewer than two points with a time. Choose a recorded track, not a planned route.</source>
        <translation>La trace a moins de deux points avec une heure. Choisissez une trace enregistrée, pas un itinéraire prévu.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The photo was taken {time} before the track begins.</source>
        <translation>La photo a été prise {time} avant le début de la trace.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The photo was taken {time} after the track ends.</source>
        <translation>La photo a été prise {time} après la fin de la trace.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The track has a gap of {time} around the photo.</source>
        <translation>La trace a un trou de {time} autour de la photo.</translation>
    </message>
    <message>
        <location filename="../core/track/zone.py"/>
        <source>The time zone {text} is not known. Write it as +05:45 or as Asia/Kathmandu.</source>
        <translation>Le fuseau horaire {text} n’est pas connu. Écrivez-le sous la forme +05:45 ou Asia/Kathmandu.</translation>
    </message>
    <message>
        <location filename="../core/viewshed/geometry.py"/>
        <source>The DEM's coordinate system distorts sight lines too strongly here. Use a DEM in a projected coordinate system, such as UTM.</source>
        <translation>Le système de coordonnées du MNT déforme ici trop les lignes de visée. Utilisez un MNT dans un système de coordonnées projeté, comme UTM.</translation>
    </message>
    <message>
        <location filename="../core/viewshed/geometry.py"/>
        <source>The DEM's coordinate system bends sight lines too strongly here (close to a pole of its grid). Use a DEM in a projected coordinate system, such as UTM or polar stereographic.</source>
        <translation>Le système de coordonnées du MNT courbe ici trop les lignes de visée (près d'un pôle de sa grille). Utilisez un MNT dans un système projeté, comme UTM ou stéréographique polaire.</translation>
    </message>
    <message>
        <location filename="../core/workers/pool.py"/>
        <source>The process that worked on this photo ended unexpectedly, perhaps because memory ran out. Run this photo again by itself, or set a smaller number of worker processes.</source>
        <translation>Le processus qui traitait cette photo s’est arrêté de façon inattendue, peut-être par manque de mémoire. Traitez de nouveau cette photo seule, ou choisissez moins de processus de travail.</translation>
    </message>
    <message>
        <location filename="../core/workers/team.py"/>
        <source>No worker processes could be started ({reason}), so one process does all the work.</source>
        <translation>Aucun processus de travail n’a pu être lancé ({reason}) ; un seul processus fait tout le travail.</translation>
    </message>
</context>
</TS>
