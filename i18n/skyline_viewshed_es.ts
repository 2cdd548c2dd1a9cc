<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>SkylineViewshed</name>
    <message>
        <location filename="../plugin.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Photos to viewsheds</source>
        <translation>De fotos a cuencas visuales</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Skyline Viewshed: choose photos and an elevation model, and run</source>
        <translation>Skyline Viewshed: elegir fotos y un modelo de elevación, y ejecutar</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Begin with the mountain button in the toolbar, or in the Processing toolbox.</source>
        <translation>Empiece con el botón de la montaña de la barra de herramientas, o en la caja de herramientas de procesos.</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Photo view</source>
        <translation>Vista de fotos</translation>
    </message>
    <message>
        <location filename="../plugin.py"/>
        <source>Look at oriented photographs beside the map, correct and measure.</source>
        <translation>Ver fotografías orientadas junto al mapa, corregirlas y medir en ellas.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Folder of photographs</source>
        <translation>Carpeta de fotografías</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Include subfolders</source>
        <translation>Incluir subcarpetas</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../panel/view/dock.py"/>
        <source>Elevation model (DEM)</source>
        <translation>Modelo digital de elevaciones (MDE)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Maximum distance (m)</source>
        <translation>Distancia máxima (m)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Land-cover raster</source>
        <translation>Ráster de cobertura del suelo</translation>
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
        <translation>Fotos orientadas</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../panel/view/actions.py"/>
        <source>Viewshed</source>
        <translation>Cuenca visual</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Ground in view</source>
        <translation>Terreno visible</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Land cover in view</source>
        <translation>Cobertura del suelo visible</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Photos to orient again</source>
        <translation>Fotos que se orientan de nuevo</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Layer to update</source>
        <translation>Capa que se actualiza</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Field with an approximate heading (°)</source>
        <translation>Campo con un rumbo aproximado (°)</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Landmarks</source>
        <translation>Puntos de referencia</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Updated layer</source>
        <translation>Capa actualizada</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Orients some photographs of a layer again, with an approximate heading or landmarks if you give them, updates the layer, and computes anew the ground that its photographs show.</source>
        <translation>Orienta de nuevo algunas fotos de una capa, con un rumbo aproximado o puntos de referencia si los indica, actualiza la capa y vuelve a calcular el terreno que muestran sus fotos.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Reads geotagged JPEG photographs with QGIS's own importer, orients them, and computes the ground they show.</source>
        <translation>Lee fotografías JPEG georreferenciadas con el importador propio de QGIS, las orienta y calcula el terreno que muestran.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Uses the headings that the cameras recorded, and computes the ground within the horizontal field of view. Phone compasses are often wrong by 5 to 10 degrees or more.</source>
        <translation>Usa los rumbos que registraron las cámaras y calcula el terreno dentro del ángulo de visión horizontal. Las brújulas de los teléfonos suelen errar entre 5 y 10 grados o más.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Counts the cells of each class of a land-cover raster within the ground that each oriented photograph shows.</source>
        <translation>Cuenta las celdas de cada clase de un ráster de cobertura del suelo dentro del terreno que muestra cada fotografía orientada.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>JPEG and HEIC files with a GPS position.</source>
        <translation>Archivos JPEG y HEIC con posición GPS.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Also searches all subfolders.</source>
        <translation>Busca también en todas las subcarpetas.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Raster of classes, in any coordinate system.</source>
        <translation>Ráster de clases, en cualquier sistema de coordenadas.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Points with heading, pitch, roll and field of view.</source>
        <translation>Puntos con rumbo, cabeceo, alabeo y ángulo de visión.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of photographs that show each cell, on the DEM's grid; nodata if it is unknown.</source>
        <translation>Número de fotografías que muestran cada celda, en la cuadrícula del MDE; sin datos si se desconoce.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>One multipolygon per photograph, with the area seen (m²) and the farthest distance (m).</source>
        <translation>Un multipolígono por fotografía, con la superficie vista (m²) y la distancia máxima (m).</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Ground in view, with the number of cells of each class in fields class_1, class_2, ...</source>
        <translation>Terreno visible, con el número de celdas de cada clase en los campos class_1, class_2, ...</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>The layer of oriented photos; select the photos and tick the box for selected features.</source>
        <translation>La capa de fotos orientadas; seleccione las fotos y marque la casilla de objetos seleccionados.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>The layer that gets the new answers; usually the same one. It is changed.</source>
        <translation>La capa que recibe los nuevos resultados; normalmente la misma. Se modifica.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Approximate true heading, clockwise from north. The answer must be near it. NULL: none.</source>
        <translation>Rumbo geográfico aproximado, en sentido horario desde el norte. La respuesta debe estar cerca de él. NULL: ninguno.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Points on the map that are visible in photographs, with the fields photo, x and y.</source>
        <translation>Puntos del mapa visibles en las fotos, con los campos photo, x e y.</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: geotagged photos to viewsheds</source>
        <translation>Modelo: de fotos georreferenciadas a cuencas visuales</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: recorded headings to viewsheds</source>
        <translation>Modelo: de rumbos registrados a cuencas visuales</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: orient photos again</source>
        <translation>Modelo: orientar fotos de nuevo</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Model: land cover that photos show</source>
        <translation>Modelo: cobertura del suelo que muestran las fotos</translation>
    </message>
    <message>
        <location filename="../processing_provider/models.py"/>
        <source>Models</source>
        <translation>Modelos</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Photographs</source>
        <translation>Fotografías</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Terrain and visibility</source>
        <translation>Terreno y visibilidad</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>All in one</source>
        <translation>Todo en uno</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>From the photo to the map</source>
        <translation>De la foto al mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Checks and simulation</source>
        <translation>Comprobación y simulación</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>Cancelled. Nothing was written.</source>
        <translation>Cancelado. No se ha escrito nada.</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>{name} cannot be kept in memory, as only vector layers can. Choose a temporary file, or name a file or folder.</source>
        <translation>{name} no se puede guardar en memoria; solo se puede con capas vectoriales. Elija un archivo temporal o indique un archivo o una carpeta.</translation>
    </message>
    <message>
        <location filename="../algorithms/base.py"/>
        <source>{name} cannot be written: {folder} is not a folder you may write to.</source>
        <translation>No se puede escribir {name}: {folder} no es una carpeta en la que usted pueda escribir.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Directed viewshed</source>
        <translation>Cuenca visual dirigida</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>viewshed,visibility,photo,field of view,frustum,wedge,dem,sector</source>
        <translation>cuenca visual,visibilidad,foto,campo de visión,pirámide de visión,sector,MDE,viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Ground that oriented photographs show: cumulative raster and one polygon per photo</source>
        <translation>Terreno que muestran fotografías orientadas: ráster acumulado y un polígono por foto</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Tests for every cell of the elevation model in range whether it is visible from the camera and lies inside the picture. &lt;i&gt;Photo frame&lt;/i&gt; uses heading, pitch, roll and both fields of view; &lt;i&gt;heading wedge&lt;/i&gt; uses only the heading and the horizontal field of view; &lt;i&gt;full circle&lt;/i&gt; uses none of them.</source>
        <translation>Comprueba, para cada celda del modelo digital de elevaciones a su alcance, si es visible desde la cámara y está dentro de la imagen. &lt;i&gt;Encuadre de la foto&lt;/i&gt; usa rumbo, cabeceo, alabeo y ambos ángulos de visión; &lt;i&gt;sector de visión&lt;/i&gt; usa solo el rumbo y el ángulo de visión horizontal; &lt;i&gt;círculo completo&lt;/i&gt; no usa ninguno de ellos.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>The raster uses the DEM's grid and counts the photographs that show each cell; cells for which this is unknown are nodata. The polygons have the area on the ellipsoid (m²) and the farthest distance (m) as attributes. Azimuths count from true north and distances are ground metres, whatever the coordinate system.</source>
        <translation>El ráster usa la cuadrícula del MDE y cuenta las fotografías que muestran cada celda; las celdas en las que se desconoce quedan sin datos. Los polígonos tienen como atributos el área sobre el elipsoide (m²) y la mayor distancia (m). Los acimutes se cuentan desde el norte geográfico y las distancias son metros sobre el terreno, sea cual sea el sistema de coordenadas.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Advanced options: layers with values per cell (distance, elevation angle, how much higher a target must be to be visible, position in the picture), probabilities that account for the errors of pose, position and DEM, and the photographs' own skylines, which exclude ground that the foreground hides. Photographs from exactly the same place are computed together.</source>
        <translation>Opciones avanzadas: capas con valores por celda (distancia, ángulo de elevación, cuánto más alto debe ser un objetivo para ser visible, posición en la imagen), probabilidades que tienen en cuenta los errores de orientación, posición y MDE, y las líneas del horizonte de las propias fotos, que excluyen el terreno que oculta el primer plano. Las fotos de exactamente un mismo lugar se calculan juntas.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>To continue a run that was stopped, repeat it with the same parameters. Finished files in the folders of rasters, layers and probabilities are reused if the DEM, the pose and the settings have not changed.</source>
        <translation>Para continuar una ejecución interrumpida, repítala con los mismos parámetros. Los archivos terminados en las carpetas de ráster, capas y probabilidades se reutilizan si el MDE, la orientación y los ajustes no han cambiado.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/panorama.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Oriented photo points</source>
        <translation>Puntos de fotos orientadas</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>From Orient photos, or any points with heading, pitch, roll and field of view.</source>
        <translation>De «Orientar fotos», o cualesquiera puntos con rumbo, cabeceo, alabeo y ángulo de visión.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the camera's elevation (m)</source>
        <translation>Campo con la altitud de la cámara (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Absolute elevation in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Altitud absoluta en el sistema altimétrico del MDE. NULL: MDE más altura de la cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Folder for one raster per photo</source>
        <translation>Carpeta para un ráster por foto</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>GeoTIFFs: 1 seen, 0 not seen, nodata unknown.</source>
        <translation>GeoTIFF: 1 visto, 0 no visto, sin datos desconocido.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of viewsheds</source>
        <translation>Número de cuencas visuales</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>The layer has no heading. Choose the field that holds it, orient the photos first, or take the full circle.</source>
        <translation>La capa no tiene rumbo. Elija el campo que lo contiene, oriente primero las fotos o tome el círculo completo.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/export_headings.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the heading (°)</source>
        <translation>Campo con el rumbo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>True, clockwise from north.</source>
        <translation>Geográfico, en sentido horario desde el norte.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the horizontal field of view (°)</source>
        <translation>Campo con el ángulo de visión horizontal (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Field of view of the upright picture.</source>
        <translation>Ángulo de visión de la imagen enderezada.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the pitch (°)</source>
        <translation>Campo con el cabeceo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Up is positive. NULL: wedge, not frame.</source>
        <translation>Positivo hacia arriba. NULL: sector en vez de encuadre.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Field with the roll (°)</source>
        <translation>Campo con el alabeo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Right side down is positive. NULL: 0.</source>
        <translation>Positivo si el lado derecho está más bajo. NULL: 0.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <location filename="../algorithms/shared/views.py"/>
        <source>Field with the vertical field of view (°)</source>
        <translation>Campo con el ángulo de visión vertical (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>NULL: wedge, not frame.</source>
        <translation>NULL: sector en vez de encuadre.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>End of the 90 % interval, used for probabilities. NULL: a standard deviation of 0.5° is used instead.</source>
        <translation>Extremo del intervalo del 90 %, usado para las probabilidades. NULL: en su lugar se usa una desviación típica de 0,5°.</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Field with the heading's lower end (°)</source>
        <translation>Campo con el extremo inferior del rumbo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/directed_viewshed.py"/>
        <source>Field with the heading's upper end (°)</source>
        <translation>Campo con el extremo superior del rumbo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Drape photos over the terrain</source>
        <translation>Extender fotos sobre el terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>orthophoto,drape,rectify,texture,mosaic,photo,rgba,ground sampling distance</source>
        <translation>ortofoto,extender,rectificar,textura,mosaico,foto,RGBA,resolución sobre el terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Colour raster on the DEM's grid: each cell as the photo shows it, transparent where hidden</source>
        <translation>Ráster en color sobre la malla del MDE: cada celda como la muestra la foto, transparente donde está oculta</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Each cell that a photograph shows gets the colour of the pixels that show it; all other cells are transparent. If several photographs show a cell, their colours are blended: the photograph with the finest resolution there has the greatest weight, and each photograph fades out towards its edges.</source>
        <translation>Cada celda que muestra una fotografía toma el color de los píxeles que la muestran; todas las demás celdas son transparentes. Si varias fotografías muestran una celda, sus colores se funden: la fotografía con la resolución más fina en ese lugar tiene el mayor peso, y cada una se desvanece hacia sus bordes.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Sky is not draped: a cell whose pixel lies above the skyline of the picture stays transparent.</source>
        <translation>El cielo no se proyecta: una celda cuyo píxel queda por encima de la línea del horizonte de la imagen permanece transparente.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>The second raster gives the ground sampling distance of the best photo in metres per pixel: band 1 across the line of sight, band 2 along it on the slope, which is long if the line of sight grazes the ground. Trees and people in the picture are draped too, because the DEM does not contain them.</source>
        <translation>El segundo ráster da la resolución sobre el terreno de la mejor foto en metros por píxel: banda 1 transversal a la línea de visión, banda 2 a lo largo de ella sobre la ladera, grande si la línea de visión roza el terreno. También se extienden los árboles y las personas de la imagen, porque el MDE no los contiene.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Cells per side of a DEM cell</source>
        <translation>Celdas por lado de una celda del MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>1: the DEM's own grid. 4: sixteen times as many cells, for a photo finer than the DEM.</source>
        <translation>1: la malla del MDE. 4: dieciséis veces más celdas, para una foto más fina que el MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Minimum distance (m)</source>
        <translation>Distancia mínima (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Ground nearer than this is left out.</source>
        <translation>El terreno más cercano se deja fuera.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Draped photos</source>
        <translation>Fotos extendidas</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>GeoTIFF of red, green, blue and opacity; transparent where no photo sees the cell.</source>
        <translation>GeoTIFF de rojo, verde, azul y opacidad; transparente donde ninguna foto ve la celda.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Ground sampling distance</source>
        <translation>Resolución sobre el terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Metres per pixel of the best photo: band 1 across the view, band 2 along it.</source>
        <translation>Metros por píxel de la mejor foto: banda 1 a través de la vista, banda 2 a lo largo.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Number of photos draped</source>
        <translation>Número de fotos extendidas</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>Number of cells with colour</source>
        <translation>Número de celdas con color</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>The point names no photo.</source>
        <translation>El punto no nombra ninguna foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/drape_photo.py"/>
        <source>{share} % of the ground in view lies where the picture shows sky, and was not draped. Check the heading, the pitch and the elevation of the camera.</source>
        <translation>El {share} % del terreno visible cae donde la imagen muestra cielo y no se ha proyectado. Compruebe el rumbo, el cabeceo y la elevación de la cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Expected accuracy</source>
        <translation>Exactitud esperada</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>simulation,accuracy,benchmark,planning,acceptance,coverage,montecarlo</source>
        <translation>simulación,exactitud,prueba comparativa,planificación,aceptación,cobertura,montecarlo</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>How accurate orientation will be at given places over a given DEM, from simulated photographs</source>
        <translation>Qué exactitud tendrá la orientación en lugares dados sobre un MDE dado, a partir de fotos simuladas</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Simulates photographs from the places with random directions, lenses, weather and errors of position and focal length, orients each of them as Orient photos does, and compares the answers with the truth: errors, share of accepted photographs, wrong ones among them, and how often the 90 % interval holds the truth.</source>
        <translation>Simula fotos desde los lugares con direcciones, objetivos, tiempo y errores de posición y distancia focal aleatorios, orienta cada una como lo hace «Orientar fotos» y compara las respuestas con la verdad: errores, proporción de fotos aceptadas, las erróneas entre ellas y con qué frecuencia el intervalo del 90 % contiene la verdad.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The simulated mountains are rougher than the DEM. Each photograph takes some seconds. Real photographs can give worse results: compare with the figures for real photographs in the documentation.</source>
        <translation>Las montañas simuladas son más rugosas que el MDE. Cada foto tarda algunos segundos. Las fotos reales pueden dar peores resultados: compare con las cifras de fotos reales en la documentación.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Places</source>
        <translation>Lugares</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Points, or lines along which places are taken.</source>
        <translation>Puntos, o líneas a lo largo de las cuales se toman lugares.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Distance between the places that are taken along lines.</source>
        <translation>Distancia entre los lugares que se toman a lo largo de líneas.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <source>Step along lines (m)</source>
        <translation>Paso a lo largo de las líneas (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>They are spread evenly over the places.</source>
        <translation>Se reparten por igual entre los lugares.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Number of photographs</source>
        <translation>Número de fotografías</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Weather</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>clear days</source>
        <translation>días despejados</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>half clear, half a season's weather</source>
        <translation>mitad despejado, mitad tiempo de una temporada</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>a season's weather</source>
        <translation>tiempo de una temporada</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>A season's weather has clouds, haze, trees, people and camera faults.</source>
        <translation>El tiempo de una temporada tiene nubes, bruma, árboles, personas y defectos de la cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Fields of view are drawn between the two.</source>
        <translation>Los ángulos de visión se eligen al azar entre los dos.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Narrowest field of view (°)</source>
        <translation>Ángulo de visión más estrecho (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Widest field of view (°)</source>
        <translation>Ángulo de visión más ancho (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Standard deviation of the recorded position in each direction.</source>
        <translation>Desviación típica de la posición registrada en cada dirección.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/position_photos.py"/>
        <source>Error of the position (m)</source>
        <translation>Error de la posición (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Roughness of the mountains that the DEM does not show, in cells of the DEM. 0: the photographs show the DEM itself.</source>
        <translation>Rugosidad de las montañas que el MDE no muestra, en celdas del MDE. 0: las fotos muestran el propio MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Roughness beyond the DEM</source>
        <translation>Rugosidad más allá del MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The same seed gives the same photographs.</source>
        <translation>La misma semilla da las mismas fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>One point per simulated photograph with its truth, the answer and the error.</source>
        <translation>Un punto por foto simulada con su verdad, la respuesta y el error.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Simulated photographs</source>
        <translation>Fotografías simuladas</translation>
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
        <translation>Número de fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/orient_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Number of accepted photos</source>
        <translation>Número de fotos aceptadas</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Accepted photos that are wrong by more than 3°</source>
        <translation>Fotos aceptadas que fallan por más de 3°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of headings within 1°</source>
        <translation>Proporción de rumbos a menos de 1°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of headings within 3°</source>
        <translation>Proporción de rumbos a menos de 3°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Share of the accepted whose interval holds the truth</source>
        <translation>Proporción de las aceptadas cuyo intervalo contiene la verdad</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The narrowest field of view must not be wider than the widest.</source>
        <translation>El ángulo de visión más estrecho no debe ser más ancho que el más ancho.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>None of the places has a usable position on this DEM.</source>
        <translation>Ninguno de los lugares tiene una posición utilizable en este MDE.</translation>
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
        <translation>El punto no tiene una posición utilizable.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>{photos} photographs: {accepted} accepted, {wrong} of them wrong by more than 3°; {within} % of all headings are within 1° of the truth.</source>
        <translation>{photos} fotografías: {accepted} aceptadas, {wrong} de ellas erróneas por más de 3°; el {within} % de todos los rumbos está a menos de 1° de la verdad.</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>True heading (°)</source>
        <translation>Rumbo verdadero (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Heading found minus true heading (°)</source>
        <translation>Rumbo encontrado menos rumbo verdadero (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>Probability of a unique answer, predicted from the DEM</source>
        <translation>Probabilidad de una respuesta única, prevista a partir del MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view (°)</source>
        <translation>Ángulo de visión horizontal (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Heading (° from true north)</source>
        <translation>Rumbo (° desde el norte geográfico)</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <source>The 90 % interval holds the true heading</source>
        <translation>El intervalo del 90 % contiene el rumbo verdadero</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Probability that the heading is right within 3°</source>
        <translation>Probabilidad de que el rumbo sea correcto dentro de 3°</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Status</source>
        <translation>Estado</translation>
    </message>
    <message>
        <location filename="../algorithms/expected_accuracy.py"/>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Export headings</source>
        <translation>Exportar rumbos</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>photo,heading,export,xmp,sidecar,kml,kmz,photooverlay,csv,google earth,lightroom,digikam</source>
        <translation>foto,rumbo,exportar,xmp,sidecar,kml,kmz,photooverlay,csv,google earth,lightroom,digikam</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Headings as XMP sidecars, KML or KMZ with the pictures, and a CSV table</source>
        <translation>Rumbos como archivos XMP adjuntos, KML o KMZ con las imágenes y una tabla CSV</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Writes the headings of oriented photographs for other programs. The photographs themselves are never changed.</source>
        <translation>Escribe los rumbos de fotos orientadas para otros programas. Las fotos mismas no se modifican nunca.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>&lt;b&gt;Sidecars&lt;/b&gt; are named IMG_1.jpg.xmp, as digiKam, darktable and ExifTool read them, with GPSImgDirection against true north. The folders below the photographs' common folder are kept, so choose that common folder to have each sidecar beside its photograph. Sidecars of other programs are left alone. &lt;b&gt;KMZ&lt;/b&gt; contains reduced pictures; &lt;b&gt;KML&lt;/b&gt; points to the originals. Google Earth shows each picture in its place.</source>
        <translation>Los &lt;b&gt;archivos adjuntos&lt;/b&gt; se llaman IMG_1.jpg.xmp, como los leen digiKam, darktable y ExifTool, con GPSImgDirection respecto al norte verdadero. Se conservan las carpetas que hay debajo de la carpeta común de las fotos; elija esa carpeta común para tener cada archivo junto a su foto. Los archivos de otros programas no se tocan. &lt;b&gt;KMZ&lt;/b&gt; contiene imágenes reducidas; &lt;b&gt;KML&lt;/b&gt; remite a los originales. Google Earth muestra cada imagen en su sitio.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Only photographs with the status &lt;i&gt;accepted&lt;/i&gt; or &lt;i&gt;confirmed&lt;/i&gt;, or without a status, are exported, unless you request the doubtful ones too.</source>
        <translation>Solo se exportan fotos con el estado &lt;i&gt;accepted&lt;/i&gt; o &lt;i&gt;confirmed&lt;/i&gt;, o sin estado, salvo que pida también las dudosas.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Clockwise from true north.</source>
        <translation>En sentido horario desde el norte verdadero.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Doubtful photos too</source>
        <translation>También fotos dudosas</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Exports photos whose heading is not reliable as well.</source>
        <translation>Exporta también fotos cuyo rumbo no es fiable.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>One XMP file per photo. Choose the photos' common folder to have each beside its photo.</source>
        <translation>Un archivo XMP por foto. Elija la carpeta común de las fotos para tener cada uno junto a su foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Folder for XMP sidecars</source>
        <translation>Carpeta para archivos XMP adjuntos</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>KML or KMZ</source>
        <translation>KML o KMZ</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>KMZ files (*.kmz);;KML files (*.kml)</source>
        <translation>Archivos KMZ (*.kmz);;Archivos KML (*.kml)</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>For Google Earth; a KMZ file contains the pictures.</source>
        <translation>Para Google Earth; un archivo KMZ contiene las imágenes.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>CSV files (*.csv)</source>
        <translation>Archivos CSV (*.csv)</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>One line per photo, for spreadsheets.</source>
        <translation>Una línea por foto, para hojas de cálculo.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Number of photos left out</source>
        <translation>Número de fotos omitidas</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>Choose at least one output: the folder for sidecars, the KML file or the table.</source>
        <translation>Elija al menos una salida: la carpeta de archivos adjuntos, el archivo KML o la tabla.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>No photo of the layer has a heading that can be exported. Orient the photos first.</source>
        <translation>Ninguna foto de la capa tiene un rumbo que se pueda exportar. Oriente primero las fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>{count} headings exported.</source>
        <translation>{count} rumbos exportados.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <location filename="../panel/model/session.py"/>
        <location filename="../core/many.py"/>
        <source>The point names no photo. Fill its path field.</source>
        <translation>El punto no nombra ninguna foto. Rellene su campo de ruta.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out, because it has no heading.</source>
        <translation>omitida, porque no tiene rumbo.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out, because its status is {status}.</source>
        <translation>omitida, porque su estado es {status}.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left out of the KML file, because its point has no position.</source>
        <translation>no está en el archivo KML, porque su punto no tiene posición.</translation>
    </message>
    <message>
        <location filename="../algorithms/export_headings.py"/>
        <source>left as it is, because another program wrote {path}.</source>
        <translation>sin cambios, porque otro programa escribió {path}.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Extract skyline</source>
        <translation>Extraer la línea del horizonte</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>photo,skyline,horizon,sky,segmentation,ridge,overlay</source>
        <translation>foto,línea del horizonte,horizonte,cielo,segmentación,cresta,superposición,skyline</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Boundary between sky and terrain in photographs, with a confidence per column</source>
        <translation>Límite entre cielo y terreno en las fotografías, con una confianza por columna</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Writes one row per picture column. &lt;b&gt;column&lt;/b&gt; and &lt;b&gt;row&lt;/b&gt; are pixels of the full upright picture (the first pixel is 0; row is the first terrain pixel). &lt;b&gt;confidence&lt;/b&gt; ranges from 0 (no plausible boundary, interpolated) to 1.</source>
        <translation>Escribe una fila por columna de la imagen. &lt;b&gt;column&lt;/b&gt; y &lt;b&gt;row&lt;/b&gt; son píxeles de la imagen completa y enderezada (el primer píxel es 0; row es el primer píxel de terreno). &lt;b&gt;confidence&lt;/b&gt; va de 0 (ningún límite verosímil, interpolado) a 1.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>If the automatic skyline is wrong, correct the table by hand and use it in &lt;i&gt;Orient photos&lt;/i&gt; as &lt;i&gt;Drawn skylines&lt;/i&gt;. The overlays are PNG pictures for checking the skyline.</source>
        <translation>Si la línea del horizonte automática es errónea, corrija la tabla a mano y úsela en &lt;i&gt;Orientar fotos&lt;/i&gt; como &lt;i&gt;Líneas del horizonte dibujadas&lt;/i&gt;. Las superposiciones son imágenes PNG para comprobar la línea del horizonte.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Robust: finds the most likely line as a whole, even with haze, clouds and noise. Paper: uses the published filters, column by column.</source>
        <translation>Robusto: halla la línea más probable en conjunto, incluso con bruma, nubes y ruido. Artículo: usa los filtros publicados, columna por columna.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Skylines</source>
        <translation>Líneas del horizonte</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>One row per picture column: photo, column and row (px of the upright picture), confidence (0 to 1).</source>
        <translation>Una fila por columna de la imagen: foto, columna y fila (px de la imagen derecha), confianza (0 a 1).</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Folder of overlays</source>
        <translation>Carpeta de superposiciones</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>One PNG per photograph with its skyline.</source>
        <translation>Un PNG por fotografía con su línea del horizonte.</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Number of skylines</source>
        <translation>Número de líneas del horizonte</translation>
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
        <translation>Columna (px, desde la izquierda)</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Row (px, from the top)</source>
        <translation>Fila (px, desde arriba)</translation>
    </message>
    <message>
        <location filename="../algorithms/extract_skyline.py"/>
        <source>Confidence (0 to 1)</source>
        <translation>Confianza (0 a 1)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Horizon profile</source>
        <translation>Perfil del horizonte</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>horizon,skyline,panorama,sky view factor,shading,elevation angle,dem</source>
        <translation>horizonte,línea del horizonte,panorama,factor de visión del cielo,sombra,ángulo de elevación,MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Elevation angle and distance of the horizon around points, and their sky view factor</source>
        <translation>Ángulo de elevación y distancia del horizonte alrededor de puntos, y su factor de visión del cielo</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Computes the elevation angle, the distance and the position of the horizon for each point and azimuth. Azimuths count from true north and distances are ground metres in any coordinate system of the DEM. The earth's curvature and refraction are taken into account.</source>
        <translation>Calcula el ángulo de elevación, la distancia y la posición del horizonte para cada punto y acimut. Los acimutes se cuentan desde el norte geográfico y las distancias son metros sobre el terreno en cualquier sistema de coordenadas del MDE. Se tienen en cuenta la curvatura terrestre y la refracción.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>&lt;b&gt;clipped&lt;/b&gt; is true if the elevation model ends before the search range and there could be higher terrain beyond it. &lt;b&gt;svf&lt;/b&gt; is the sky view factor of the source point (1 = open sky).</source>
        <translation>&lt;b&gt;clipped&lt;/b&gt; es verdadero si el MDE termina antes del alcance de búsqueda y más allá podría haber terreno más alto. &lt;b&gt;svf&lt;/b&gt; es el factor de visión del cielo del punto de origen (1 = cielo despejado).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Under Advanced you can add a raster with the sky view factor of each cell in an extent, which takes the cell's own slope into account (Dozier and Frew 1990).</source>
        <translation>En Avanzado puede añadir un ráster con el factor de visión del cielo de cada celda de una extensión, que tiene en cuenta la pendiente propia de la celda (Dozier y Frew 1990).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Positions of the observer's eye, in any coordinate system.</source>
        <translation>Posiciones del ojo del observador, en cualquier sistema de coordenadas.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth step (°)</source>
        <translation>Paso de acimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Spacing of the directions; it is rounded so that it divides the circle.</source>
        <translation>Separación de las direcciones; se redondea de modo que divida el círculo.</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../core/figures/profile.py"/>
        <source>Horizon</source>
        <translation>Horizonte</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>One point per azimuth at the position of the horizon, with elevation angle (°) and distance (m).</source>
        <translation>Un punto por acimut en la posición del horizonte, con ángulo de elevación (°) y distancia (m).</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Number of points with a horizon</source>
        <translation>Número de puntos con horizonte</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/panorama.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Source point</source>
        <translation>Punto de origen</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Azimuth (° from true north)</source>
        <translation>Acimut (° desde el norte geográfico)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Elevation angle of the horizon (°)</source>
        <translation>Ángulo de elevación del horizonte (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Distance of the horizon (m)</source>
        <translation>Distancia del horizonte (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Cut off by the DEM's edge</source>
        <translation>Cortado por el borde del MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/horizon_profile.py"/>
        <source>Sky view factor of the source point</source>
        <translation>Factor de visión del cielo del punto de origen</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Import mountain photos</source>
        <translation>Importar fotos de montaña</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>photo,exif,heic,jpeg,geotag,gps,import,focal length,compass</source>
        <translation>foto,EXIF,HEIC,JPEG,geoetiqueta,GPS,importar,distancia focal,brújula</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Point layer of the photographs in a folder, with field of view and compass reference</source>
        <translation>Capa de puntos de las fotografías de una carpeta, con ángulo de visión y referencia de la brújula</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Makes one point per photograph with a position. It writes the same fields as QGIS's &lt;i&gt;Import geotagged photos&lt;/i&gt; and adds what orientation needs: 35 mm equivalent, field of view, size of the upright picture, reference of the compass (true or magnetic), GPS error, camera.</source>
        <translation>Crea un punto por fotografía con posición. Escribe los mismos campos que &lt;i&gt;Importar fotos geoetiquetadas&lt;/i&gt; de QGIS y añade lo que la orientación necesita: distancia focal equivalente en 35 mm, ángulo de visión, tamaño de la imagen enderezada, referencia de la brújula (geográfica o magnética), error del GPS, cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Values that a file does not contain are NULL. The optional table of rejected photographs lists photographs without a usable position and files that cannot be read, with the reason.</source>
        <translation>Los valores que un archivo no contiene son NULL. La tabla opcional de fotografías rechazadas enumera las fotografías sin posición utilizable y los archivos ilegibles, con el motivo.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>JPEG and HEIC files, and PNG, TIFF and WebP files that record a position.</source>
        <translation>Archivos JPEG y HEIC, y archivos PNG, TIFF y WebP que registran una posición.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>One point per photograph at the recorded position, with the recorded altitude as Z.</source>
        <translation>Un punto por fotografía en la posición registrada, con la altitud registrada como Z.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Rejected photos</source>
        <translation>Fotos rechazadas</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Table of the files that produced no point, with the reason.</source>
        <translation>Tabla de los archivos que no produjeron ningún punto, con el motivo.</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>Number of rejected photos</source>
        <translation>Número de fotos rechazadas</translation>
    </message>
    <message>
        <location filename="../algorithms/import_photos.py"/>
        <source>The photo has no GPS position.</source>
        <translation>La foto no tiene posición GPS.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Label peaks in photos</source>
        <translation>Rotular cimas en las fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>peak,summit,mountain,name,label,annotate,prominence,openstreetmap,geonames</source>
        <translation>cima,cumbre,montaña,nombre,rótulo,anotar,prominencia,OpenStreetMap,GeoNames</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summits in the picture with visibility, distance and position; annotated PNG and SVG</source>
        <translation>Cimas en la imagen con visibilidad, distancia y posición; PNG y SVG rotulados</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Uses a point layer with names and heights (OpenStreetMap &lt;i&gt;natural=peak&lt;/i&gt;, GeoNames), or finds summits in the elevation model by their prominence. Each published summit is moved to the nearby top in the DEM, because published positions and coarse DEMs differ by hundreds of metres. Then its visibility in the photo is tested.</source>
        <translation>Usa una capa de puntos con nombres y altitudes (OpenStreetMap &lt;i&gt;natural=peak&lt;/i&gt;, GeoNames), o busca cimas en el MDE por su prominencia. Cada cima publicada se desplaza al punto alto cercano del MDE, porque las posiciones publicadas y los MDE gruesos difieren en cientos de metros. Después se comprueba su visibilidad en la foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Labels never overlap. The more important summit (by prominence, otherwise by height above the others in view) gets the better place. Labels without room are left out of the picture; the layer contains all summits.</source>
        <translation>Los rótulos nunca se solapan. La cima más importante (por prominencia; si no, por su altura sobre las demás a la vista) obtiene el mejor sitio. Los rótulos sin sitio se omiten en la imagen; la capa contiene todas las cimas.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summits in photos</source>
        <translation>Cimas en las fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>One point for each photo and each summit in its frame, with name, distance (m) and position in the picture (px).</source>
        <translation>Un punto por cada foto y cada cima en su encuadre, con nombre, distancia (m) y posición en la imagen (px).</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>One PNG and one SVG per photo with the names written in.</source>
        <translation>Un PNG y un SVG por foto con los nombres escritos.</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Folder for labelled photos</source>
        <translation>Carpeta de fotos rotuladas</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Number of summits in frame</source>
        <translation>Número de cimas en el encuadre</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Number of visible summits</source>
        <translation>Número de cimas visibles</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Summit</source>
        <translation>Cima</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Published height, otherwise height in the DEM (m)</source>
        <translation>Altitud publicada; si no, altitud en el MDE (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Height of the DEM's top (m)</source>
        <translation>Altitud del punto alto en el MDE (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Moved to the DEM's top by (m)</source>
        <translation>Movida al punto alto del MDE (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>Prominence in the DEM (m), if summits were searched</source>
        <translation>Prominencia en el MDE (m), si se buscaron cimas</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <source>visible, hidden, unknown</source>
        <translation>visible (visible), hidden (oculta), unknown (desconocido)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Column (px)</source>
        <translation>Columna (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Row (px)</source>
        <translation>Fila (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Distance (m)</source>
        <translation>Distancia (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/label_peaks.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Elevation angle (°)</source>
        <translation>Ángulo de elevación (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Locate photos</source>
        <translation>Localizar fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>position,place,where,geolocation,photo,skyline,horizon,archive,search,gps,geotag</source>
        <translation>posición,lugar,dónde,geolocalización,foto,línea del horizonte,horizonte,archivo,búsqueda,gps,geotag</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Where photographs were taken, from their skyline and a DEM alone</source>
        <translation>Dónde se tomaron las fotografías, solo a partir de su línea del horizonte y de un MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Compares the skyline of each photograph with the horizons of all places of an area, and gives the place, heading, pitch and roll that fit best. No position is needed in the photographs.</source>
        <translation>Compara la línea del horizonte de cada fotografía con los horizontes de todos los lugares de un área y da el lugar, el rumbo, el cabeceo y el alabeo que mejor encajan. Las fotografías no necesitan posición.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>&lt;b&gt;status&lt;/b&gt; is &lt;i&gt;accepted&lt;/i&gt; (the place can be trusted), &lt;i&gt;ambiguous&lt;/i&gt; (compare the candidates), &lt;i&gt;rejected&lt;/i&gt; (the photograph was probably not taken in this area, or its skyline does not decide) or &lt;i&gt;failed&lt;/i&gt;. &lt;b&gt;p_correct&lt;/b&gt; is the probability that the place is within 500 m and the heading within 3 degrees of the truth.</source>
        <translation>&lt;b&gt;status&lt;/b&gt; es &lt;i&gt;accepted&lt;/i&gt; (se puede confiar en el lugar), &lt;i&gt;ambiguous&lt;/i&gt; (compare los candidatos), &lt;i&gt;rejected&lt;/i&gt; (probablemente la fotografía no se tomó en esta área, o su línea del horizonte no decide) o &lt;i&gt;failed&lt;/i&gt;. &lt;b&gt;p_correct&lt;/b&gt; es la probabilidad de que el lugar esté a menos de 500 m y el rumbo a menos de 3 grados de la verdad.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>The horizons of the area are computed once, about 2 ms for each place. Choose a folder for them to use them again. A wide view of far mountains can be located well; a telephoto view or a near slope cannot. A place can reveal where people live or were: use the answer responsibly.</source>
        <translation>Los horizontes del área se calculan una vez, unos 2 ms por lugar. Elija una carpeta para ellos si quiere volver a usarlos. Una vista amplia de montañas lejanas se localiza bien; un teleobjetivo o una ladera cercana, no. Un lugar puede revelar dónde viven o estuvieron personas: use la respuesta con responsabilidad.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>One point per photograph, in place of a folder. Its position is the centre of a search in a radius; otherwise it is only compared with the answer.</source>
        <translation>Un punto por fotografía, en lugar de una carpeta. Su posición es el centro de una búsqueda en un radio; de lo contrario solo se compara con la respuesta.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Best places</source>
        <translation>Mejores lugares</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>One point per photograph at the best place.</source>
        <translation>Un punto por fotografía en el mejor lugar.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Candidate places</source>
        <translation>Lugares candidatos</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>The best places of each photograph, ranked, with the pose at each.</source>
        <translation>Los mejores lugares de cada fotografía, por orden, con la pose en cada uno.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Regions of 90 % probability</source>
        <translation>Regiones de 90 % de probabilidad</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Polygons that hold 90 % of the probability if the photograph was taken in the area.</source>
        <translation>Polígonos que contienen el 90 % de la probabilidad si la fotografía se tomó en el área.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Distance between the places that are tried; the best of them are moved afterwards.</source>
        <translation>Distancia entre los lugares que se prueban; los mejores se desplazan después.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Spacing of the places (m)</source>
        <translation>Separación de los lugares (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <source>Field of view of the upright picture. NULL: computed from the focal length in the file.</source>
        <translation>Ángulo de visión de la imagen derecha. NULL: calculado a partir de la distancia focal del archivo.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Tried for photographs without a focal length and without a given field of view.</source>
        <translation>Se prueba con fotografías sin distancia focal y sin ángulo de visión dado.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Narrowest field of view to try (°)</source>
        <translation>Ángulo de visión más estrecho que se prueba (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Widest field of view to try (°)</source>
        <translation>Ángulo de visión más ancho que se prueba (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Greatest height of the camera above the ground, for towers and drones. Heights up to it are tried.</source>
        <translation>Mayor altura de la cámara sobre el suelo, para torres y drones. Se prueban alturas hasta ella.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Greatest camera height (m)</source>
        <translation>Mayor altura de la cámara (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/position_check.py"/>
        <source>Maximum distance of the mountains on the skyline, in metres on the ground.</source>
        <translation>Distancia máxima de las montañas de la línea del horizonte, en metros sobre el terreno.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Largest index of horizons that is held in memory; a folder for the index has no such limit.</source>
        <translation>Mayor índice de horizontes que se guarda en memoria; una carpeta para el índice no tiene ese límite.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Memory for the index (MB)</source>
        <translation>Memoria para el índice (MB)</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Keeps the horizons of the area, about 3 kB for each place, so that later runs start at once.</source>
        <translation>Guarda los horizontes del área, unos 3 kB por lugar, para que las ejecuciones posteriores empiecen enseguida.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>Folder for the index</source>
        <translation>Carpeta para el índice</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>A point without a photo</source>
        <translation>Un punto sin foto</translation>
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
        <translation>Se produjo un error inesperado en esta foto. Comuníquelo, por favor, y adjunte el registro.</translation>
    </message>
    <message>
        <location filename="../algorithms/locate_photos.py"/>
        <source>{count} places are searched.</source>
        <translation>Se examinan {count} lugares.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Map to pixels</source>
        <translation>Del mapa a los píxeles</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>project,overlay,photo,pixel,visible,hidden,trail,outline,annotate,augmented</source>
        <translation>proyectar,superposición,foto,píxel,visible,oculto,sendero,contorno,anotar,realidad aumentada</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Where points, lines and areas of the map appear in oriented photos, and what hides them</source>
        <translation>Dónde aparecen puntos, líneas y áreas del mapa en fotos orientadas, y qué los oculta</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Converts points, lines (such as a trail) and areas (such as a glacier's outline of 1900) to image coordinates. Lines and outlines follow the terrain and are cut where they disappear behind it or leave the picture. The state of each piece is &lt;b&gt;visible&lt;/b&gt;, &lt;b&gt;hidden&lt;/b&gt;, &lt;b&gt;outside&lt;/b&gt; or &lt;b&gt;unknown&lt;/b&gt; (no elevation there). For areas, the visible share is given as well.</source>
        <translation>Convierte puntos, líneas (como un sendero) y áreas (como el contorno de un glaciar de 1900) en coordenadas de imagen. Líneas y contornos siguen el terreno y se cortan donde desaparecen detrás de él o salen de la imagen. El estado de cada trozo es &lt;b&gt;visible&lt;/b&gt; (visible), &lt;b&gt;hidden&lt;/b&gt; (oculto), &lt;b&gt;outside&lt;/b&gt; (fuera) o &lt;b&gt;unknown&lt;/b&gt; (sin altitud allí). Para las áreas se da además la parte visible.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>A point with a height is a summit if the ground at its place is lower. It is then moved to the nearby top in the DEM, as in &lt;i&gt;Label peaks in photos&lt;/i&gt;: published positions and coarse DEMs differ by hundreds of metres.</source>
        <translation>Un punto con altitud es una cumbre si el terreno en su lugar es más bajo. Entonces se traslada a la cima cercana del MDE, como en &lt;i&gt;Rotular cimas en las fotos&lt;/i&gt;: las posiciones publicadas y los MDE gruesos difieren en cientos de metros.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>The output has the coordinates of the picture as QGIS shows it without georeference: x to the right, y negative downwards from the upper left corner. Load it together with the photo. The fields &lt;b&gt;x_px&lt;/b&gt; and &lt;b&gt;y_px&lt;/b&gt; count from the centre of the first pixel, with y downwards.</source>
        <translation>La salida tiene las coordenadas de la imagen tal como QGIS la muestra sin georreferencia: x a la derecha, y negativa hacia abajo desde la esquina superior izquierda. Cárguela junto con la foto. Los campos &lt;b&gt;x_px&lt;/b&gt; e &lt;b&gt;y_px&lt;/b&gt; cuentan desde el centro del primer píxel, con y hacia abajo.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Map features</source>
        <translation>Objetos del mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points, lines or areas in any coordinate system. Heights are taken from the DEM; Z values are ignored.</source>
        <translation>Puntos, líneas o áreas en cualquier sistema de coordenadas. Las altitudes se toman del MDE; los valores Z se ignoran.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/shared/summit_input.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Field with names</source>
        <translation>Campo con los nombres</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Written to the output and into the pictures.</source>
        <translation>Se escribe en la salida y en las imágenes.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Points with a height that their ground does not reach are summits. NULL: the point lies on the ground.</source>
        <translation>Los puntos con una altitud que su terreno no alcanza son cumbres. NULL: el punto está sobre el terreno.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Height above ground (m)</source>
        <translation>Altura sobre el terreno (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Height of points above the ground. Lines and areas lie on the ground.</source>
        <translation>Altura de los puntos sobre el suelo. Las líneas y las áreas están sobre el suelo.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Step along lines (px)</source>
        <translation>Paso a lo largo de las líneas (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines are followed in steps of this length.</source>
        <translation>Las líneas se siguen en pasos de esta longitud.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points in pictures</source>
        <translation>Puntos en las imágenes</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Points in pixels of the photo as QGIS shows it (not rotated), with negative y for rows; x_px and y_px count on the upright picture. The field state tells whether the photo shows them.</source>
        <translation>Puntos en píxeles de la foto tal como la muestra QGIS (sin girar), con y negativa para las filas; x_px e y_px cuentan en la imagen derecha. El campo state dice si la foto los muestra.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines and outlines in pictures</source>
        <translation>Líneas y contornos en las imágenes</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines and outlines in pixels of the photo as QGIS shows it (not rotated), with negative y for rows, cut where their visibility changes.</source>
        <translation>Líneas y contornos en píxeles de la foto tal como la muestra QGIS (sin girar), con y negativa para las filas, cortados donde cambia su visibilidad.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>One PNG and one SVG per photo with the features drawn in; hidden parts are dashed.</source>
        <translation>Un PNG y un SVG por foto con los objetos dibujados; las partes ocultas van a trazos.</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Folder for annotated photos</source>
        <translation>Carpeta de fotos anotadas</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Number of points and pieces</source>
        <translation>Número de puntos y trozos</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Number of visible points and pieces</source>
        <translation>Número de puntos y trozos visibles</translation>
    </message>
    <message>
        <location filename="../algorithms/map_to_pixel.py"/>
        <source>Lines in pictures</source>
        <translation>Líneas en las imágenes</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Measure angular offsets</source>
        <translation>Medir desviaciones angulares</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>accuracy,landmark,offset,skyline,evaluation,table</source>
        <translation>exactitud,punto de referencia,desviación,línea del horizonte,evaluación,tabla</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Angular offsets between extracted and synthetic skyline from landmark pairs</source>
        <translation>Desviaciones angulares entre la línea del horizonte extraída y la sintética, a partir de pares de puntos de referencia</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Each row of the table is one feature, a summit or a notch, clicked on the skyline of the photograph (extracted) and on the projected horizon (synthetic), in pixels of the upright picture. Offsets are synthetic minus extracted: azimuth positive to the right, elevation positive upwards.</source>
        <translation>Cada fila de la tabla es un rasgo, una cima o una brecha, marcado en la línea del horizonte de la fotografía (extraída) y en el horizonte proyectado (sintético), en píxeles de la imagen enderezada. Las desviaciones son sintético menos extraído: en acimut, positivas a la derecha; en elevación, positivas hacia arriba.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table needs the fields photo, x_extracted, y_extracted, x_synthetic, y_synthetic (or x1, y1, x2, y2). Picture size and fields of view are read from the fields width, height, hfov and vfov if they exist, otherwise from the photo file by the published rule. The output contains the means of the absolute offsets per photograph; the means over all pairs are returned as results.</source>
        <translation>La tabla necesita los campos photo, x_extracted, y_extracted, x_synthetic, y_synthetic (o x1, y1, x2, y2). El tamaño de la imagen y los ángulos de visión se leen de los campos width, height, hfov y vfov si existen; si no, del archivo de la foto, según la regla publicada. La salida contiene las medias de las desviaciones absolutas por fotografía; las medias de todos los pares se devuelven como resultados.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Table of landmark pairs</source>
        <translation>Tabla de pares de puntos de referencia</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>One row per pair; pixels of the upright picture.</source>
        <translation>Una fila por par; píxeles de la imagen enderezada.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Field {name}</source>
        <translation>Campo {name}</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>If this is empty, the first of {names} that the table contains is used.</source>
        <translation>Si se deja vacío, se usa el primero de {names} que contenga la tabla.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Offsets per photo</source>
        <translation>Desviaciones por foto</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>One row per photograph: number of pairs and mean offsets in azimuth, elevation and in total (°).</source>
        <translation>Una fila por fotografía: número de pares y desviaciones medias en acimut, elevación y en total (°).</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Number of pairs</source>
        <translation>Número de pares</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean azimuth offset over all pairs (°)</source>
        <translation>Desviación media en acimut de todos los pares (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean elevation offset over all pairs (°)</source>
        <translation>Desviación media en elevación de todos los pares (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean total offset over all pairs (°)</source>
        <translation>Desviación total media de todos los pares (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table has no complete pair. Fill photo and all four coordinates.</source>
        <translation>La tabla no tiene ningún par completo. Rellene photo y las cuatro coordenadas.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The table has no field {field}. It has {fields}; choose the right one under Advanced.</source>
        <translation>La tabla no tiene el campo {field}. Tiene {fields}; elija el correcto en Avanzado.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>The photo has no focal length (35 mm equivalent). Give its fields of view in HFOV_FIELD.</source>
        <translation>La foto no tiene distancia focal (equivalente en 35 mm). Dé sus ángulos de visión en HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Pairs</source>
        <translation>Pares</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean azimuth offset (°)</source>
        <translation>Desviación media en acimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean elevation offset (°)</source>
        <translation>Desviación media en elevación (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean total offset (°)</source>
        <translation>Desviación total media (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean signed azimuth offset (°)</source>
        <translation>Desviación media con signo en acimut (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/measure_offsets.py"/>
        <source>Mean signed elevation offset (°)</source>
        <translation>Desviación media con signo en elevación (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Merge oriented photos</source>
        <translation>Combinar fotos orientadas</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>photo,heading,update,merge,rescue,again,ambiguous,rejected,join</source>
        <translation>foto,rumbo,actualizar,combinar,rescate,de nuevo,ambiguo,rechazado,unir</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Updates a layer of oriented photos with photos that were oriented again</source>
        <translation>Actualiza una capa de fotos orientadas con fotos orientadas de nuevo</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>When a few photographs have been oriented again, with a hint or a landmark, this puts their answers into the layer that they came from. Photographs are recognised by their path; all others, all other fields and the points' positions stay as they are.</source>
        <translation>Cuando algunas fotos se han orientado de nuevo, con una pista o un punto de referencia, esto lleva sus resultados a la capa de la que proceden. Las fotos se reconocen por su ruta; las demás fotos, los demás campos y las posiciones de los puntos quedan como están.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>The layer itself is changed. If it is being edited, the changes join your unsaved ones and can be undone. Run &lt;i&gt;Directed viewshed&lt;/i&gt; on it afterwards to renew the ground in view, or use &lt;i&gt;Model: orient photos again&lt;/i&gt;, which does all three steps.</source>
        <translation>La capa misma se modifica. Si se está editando, los cambios se suman a los suyos no guardados y se pueden deshacer. Ejecute después &lt;i&gt;Cuenca visual dirigida&lt;/i&gt; con ella para renovar el terreno visible, o use &lt;i&gt;Modelo: orientar fotos de nuevo&lt;/i&gt;, que hace los tres pasos.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Oriented photos of an earlier run. This layer is changed.</source>
        <translation>Fotos orientadas de una ejecución anterior. Esta capa se modifica.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Photos that were oriented again</source>
        <translation>Fotos orientadas de nuevo</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>The output of Orient photos for some photos of that layer.</source>
        <translation>La salida de «Orientar fotos» para algunas fotos de esa capa.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Keep a better status</source>
        <translation>Conservar un estado mejor</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>A photo whose new status is worse than its present one keeps its present answer.</source>
        <translation>Una foto cuyo nuevo estado es peor que el actual conserva su resultado actual.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of updated photos</source>
        <translation>Número de fotos actualizadas</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of photos that keep a better status</source>
        <translation>Número de fotos que conservan un estado mejor</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>Number of photos that the layer does not have</source>
        <translation>Número de fotos que la capa no tiene</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} cannot be changed. Save it as a GeoPackage first.</source>
        <translation>{name} no se puede modificar. Guárdela antes como GeoPackage.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} has no field {field}. Choose a layer of oriented photos.</source>
        <translation>{name} no tiene el campo {field}. Elija una capa de fotos orientadas.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name}: the layer does not have this photo.</source>
        <translation>{name}: la capa no tiene esta foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name}: stays {before}; the new answer is {after}.</source>
        <translation>{name}: sigue {before}; el nuevo resultado es {after}.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../core/report/compass.py"/>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{count} photos updated.</source>
        <translation>{count} fotos actualizadas.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} occurs more than once; its best status is used.</source>
        <translation>{name} aparece más de una vez; se usa su mejor estado.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} cannot be changed now.</source>
        <translation>{name} no se puede modificar ahora.</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>a value does not fit its field</source>
        <translation>un valor no cabe en su campo</translation>
    </message>
    <message>
        <location filename="../algorithms/merge_oriented.py"/>
        <source>{name} was not changed: {reason}</source>
        <translation>{name} no se modificó: {reason}</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Orient photos</source>
        <translation>Orientar fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>photo,heading,azimuth,direction,orientation,pose,skyline,horizon,compass,pitch,roll</source>
        <translation>foto,rumbo,acimut,dirección,orientación,pose,línea del horizonte,horizonte,brújula,cabeceo,alabeo,heading</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Heading, pitch and roll of mountain photographs from their skyline and a DEM</source>
        <translation>Rumbo, cabeceo y alabeo de fotografías de montaña a partir de su línea del horizonte y un MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Compares the skyline in each photograph with the horizon computed from the elevation model at its position, over all headings, and fits heading, pitch, roll and focal length. No compass is needed.</source>
        <translation>Compara la línea del horizonte de cada fotografía con el horizonte calculado en su posición a partir del modelo digital de elevaciones, en todos los rumbos, y ajusta rumbo, cabeceo, alabeo y distancia focal. No hace falta brújula.</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>&lt;b&gt;status&lt;/b&gt; is &lt;i&gt;accepted&lt;/i&gt; (the answer can be trusted), &lt;i&gt;ambiguous&lt;/i&gt; (another heading fits nearly as well, or the fit is weak; see heading_2 and the report), &lt;i&gt;rejected&lt;/i&gt; (there is no usable skyline, or no heading fits) or &lt;i&gt;failed&lt;/i&gt; (the input cannot be used). &lt;b&gt;message&lt;/b&gt; gives the reason and suggests what to do. heading_lo and heading_hi enclose the true heading with a probability of 90 %. For an accepted photo this holds if its heading is the right one; &lt;b&gt;p_correct&lt;/b&gt; is the probability of that.</source>
        <translation>&lt;b&gt;status&lt;/b&gt; es &lt;i&gt;accepted&lt;/i&gt; (aceptada: la respuesta es fiable), &lt;i&gt;ambiguous&lt;/i&gt; (ambigua: otro rumbo encaja casi igual de bien, o el ajuste es débil; véanse heading_2 y el informe), &lt;i&gt;rejected&lt;/i&gt; (rechazada: no hay línea del horizonte utilizable, o ningún rumbo encaja) o &lt;i&gt;failed&lt;/i&gt; (fallida: la entrada no se puede usar). &lt;b&gt;message&lt;/b&gt; da el motivo y sugiere qué hacer. heading_lo y heading_hi encierran el rumbo verdadero con una probabilidad del 90 %. En una foto aceptada esto vale si su rumbo es el correcto; &lt;b&gt;p_correct&lt;/b&gt; es la probabilidad de que lo sea.</translation>
    </message>
    <message>
        <location filename="../algorithms/orient_photos.py"/>
        <source>Headings count clockwise from true north. A point's geometry is the camera's position. For photos that fail, give an approximate heading, a landmark, a drawn skyline or a sky mask (Advanced).</source>
        <translation>Los rumbos se cuentan en sentido horario desde el norte geográfico. La geometría de un punto es la posición de la cámara. Para las fotos que fallan, dé un rumbo aproximado, un punto de referencia, una línea del horizonte dibujada o una máscara del cielo (Avanzado).</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>Orientability</source>
        <translation>Orientabilidad</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>planning,camera,webcam,repeat photography,horizon,ambiguity,accuracy,prediction</source>
        <translation>planificación,cámara,webcam,fotografía repetida,horizonte,ambigüedad,exactitud,predicción</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>How well a photo from a place could be oriented, by direction and field of view, from the DEM alone</source>
        <translation>Qué bien se podría orientar una foto desde un lugar, por dirección y ángulo de visión, solo a partir del MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Compares each stretch of the horizon with all others, as a photograph of it would be compared, and predicts the probability that its heading is found and the error of that heading. Use it to plan cameras and repeat photography.</source>
        <translation>Compara cada tramo del horizonte con todos los demás, como se compararía una fotografía de él, y prevé la probabilidad de que se encuentre su rumbo y el error de ese rumbo. Sirve para planificar cámaras y fotografía repetida.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>A horizon that repeats itself, a flat one and a narrow field of view are hard to orient, and the probability tells them from distinct ones. Where the terrain is distinct, photographs still fail on clouds, trees and near slopes, which the DEM does not show.</source>
        <translation>Un horizonte que se repite, uno plano y un campo de visión estrecho son difíciles de orientar, y la probabilidad los distingue de los inconfundibles. Donde el terreno es inconfundible, las fotos todavía fallan por nubes, árboles y laderas cercanas, que el DEM no muestra.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Horizontal fields of view (°)</source>
        <translation>Ángulos de visión horizontales (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Numbers between 5 and 120, separated by commas.</source>
        <translation>Números entre 5 y 120, separados por comas.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Standard deviation of the camera's position; it matters if terrain is near.</source>
        <translation>Desviación típica de la posición de la cámara; importa si hay terreno cercano.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Extent of the raster</source>
        <translation>Extensión del ráster</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Area of the optional raster.</source>
        <translation>Área del ráster opcional.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Size of the cells of the raster, rounded to whole cells of the DEM.</source>
        <translation>Tamaño de las celdas del ráster, redondeado a celdas enteras del MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Cells of the raster (m)</source>
        <translation>Celdas del ráster (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>One point per place and field of view, with the probability in eight directions.</source>
        <translation>Un punto por lugar y ángulo de visión, con la probabilidad en ocho direcciones.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Orientability of places</source>
        <translation>Orientabilidad de los lugares</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Bands: mean probability, probability in eight directions, and expected error (°), for the first field of view.</source>
        <translation>Bandas: probabilidad media, probabilidad en ocho direcciones y error esperado (°), para el primer ángulo de visión.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Number of places</source>
        <translation>Número de lugares</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Choose places, or an extent and a raster to write.</source>
        <translation>Elija lugares, o una extensión y un ráster para escribir.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Choose the extent of the raster.</source>
        <translation>Elija la extensión del ráster.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>The fields of view must be numbers between 5 and 120, separated by commas.</source>
        <translation>Los ángulos de visión deben ser números entre 5 y 120, separados por comas.</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Probability of a unique answer towards {direction}</source>
        <translation>Probabilidad de una respuesta única hacia {direction}</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Mean probability of a unique answer</source>
        <translation>Probabilidad media de una respuesta única</translation>
    </message>
    <message>
        <location filename="../algorithms/orientability.py"/>
        <source>Expected error of the heading (°)</source>
        <translation>Error esperado del rumbo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Outline panorama</source>
        <translation>Panorama de contornos</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>panorama,horizon,skyline,ridge,outline,360,peaks,labels,svg</source>
        <translation>panorama,horizonte,línea del horizonte,cresta,contorno,360,cimas,rótulos,SVG</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Labelled horizon and inner ridges in all directions from a point, as SVG, PNG and map lines</source>
        <translation>Horizonte y crestas interiores rotulados en todas las direcciones desde un punto, como SVG, PNG y líneas del mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>For each point, draws the horizon and every inner ridge that hides ground behind it. Near ridges are dark and thick, distant ones pale. Summits come from a layer, or are found in the DEM by their prominence. Optionally, the frames of oriented photos near the point are drawn.</source>
        <translation>Dibuja, para cada punto, el horizonte y cada cresta interior que oculta terreno detrás de ella. Las crestas cercanas son oscuras y gruesas; las lejanas, pálidas. Las cimas proceden de una capa, o se hallan en el MDE por su prominencia. Opcionalmente se dibujan los encuadres de las fotos orientadas cercanas al punto.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The line layer holds the same ridges on the map, with distance and elevation angle.</source>
        <translation>La capa de líneas contiene las mismas crestas en el mapa, con distancia y ángulo de elevación.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The frames of photos within 100 m of a point are drawn, from the fields heading, pitch, roll, hfov and vfov.</source>
        <translation>Se dibujan los encuadres de las fotos a menos de 100 m de un punto, según los campos heading, pitch, roll, hfov y vfov.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Angle between neighbouring rays.</source>
        <translation>Ángulo entre rayos contiguos.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth at the left edge (°)</source>
        <translation>Acimut del borde izquierdo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Azimuth at which the panorama begins.</source>
        <translation>Acimut en el que empieza el panorama.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Pixels per degree</source>
        <translation>Píxeles por grado</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Size of the drawing.</source>
        <translation>Tamaño del dibujo.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Exaggeration of heights</source>
        <translation>Exageración de las alturas</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>1: true shape.</source>
        <translation>1: forma verdadera.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>One PNG and one SVG per point.</source>
        <translation>Un PNG y un SVG por punto.</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Folder for panoramas</source>
        <translation>Carpeta de panoramas</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Ridges in view</source>
        <translation>Crestas a la vista</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>The drawn ridges as lines on the map, with distance (m) and elevation angle (°).</source>
        <translation>Las crestas dibujadas como líneas en el mapa, con distancia (m) y ángulo de elevación (°).</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Number of panoramas</source>
        <translation>Número de panoramas</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>horizon or ridge</source>
        <translation>horizon (horizonte) o ridge (cresta)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Begins at azimuth (° from true north)</source>
        <translation>Empieza en el acimut (° desde el norte geográfico)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Ends at azimuth (° from true north)</source>
        <translation>Termina en el acimut (° desde el norte geográfico)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Median distance (m)</source>
        <translation>Distancia mediana (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/panorama.py"/>
        <source>Highest elevation angle (°)</source>
        <translation>Mayor ángulo de elevación (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Coverage of a photo collection</source>
        <translation>Cobertura de una colección de fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>coverage,blind spot,viewshed,cumulative,set cover,monitoring,fewest,photos,gsd</source>
        <translation>cobertura,punto ciego,cuenca visual,acumulado,cobertura de conjuntos,seguimiento,menos fotos,resolución sobre el terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>How often and how finely each cell is photographed, blind spots, and the fewest photos needed</source>
        <translation>Cuántas veces y con qué finura está fotografiada cada celda, puntos ciegos y las menos fotos necesarias</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Counts the photographs that see each cell of the area (0 is a blind spot) and gives the finest ground sampling distance among them in metres per pixel, across the line of sight.</source>
        <translation>Cuenta las fotografías que ven cada celda del área (0 es un punto ciego) y da la resolución sobre el terreno más fina de ellas en metros por píxel, transversal a la línea de visión.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>The table gives how much each photograph shows, and which photographs are needed: as few as possible that together show everything the collection shows, in the order of how much each adds (&lt;b&gt;pick&lt;/b&gt;). PROVEN is true if it was proven that no smaller selection exists.</source>
        <translation>La tabla indica cuánto muestra cada fotografía y qué fotografías son necesarias: las menos posibles que juntas muestran todo lo que muestra la colección, en el orden de lo que añade cada una (&lt;b&gt;pick&lt;/b&gt;). PROVEN es verdadero si se demostró que no existe una selección menor.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Only ground inside the area counts. If this is empty, all ground of the DEM within the maximum distance of the photos counts.</source>
        <translation>Solo cuenta el terreno dentro del área. Si se deja vacía, cuenta todo el terreno del MDE dentro de la distancia máxima de las fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Number of photographs that show each cell, on the DEM's grid. 0 is a blind spot; nodata is outside the area.</source>
        <translation>Número de fotografías que muestran cada celda, en la cuadrícula del MDE. 0 es un punto ciego; sin datos queda fuera del área.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Best ground sampling distance</source>
        <translation>Mejor resolución sobre el terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Metres per pixel of the best photo, across the view.</source>
        <translation>Metros por píxel de la mejor foto, a través de la vista.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Photos and what they add</source>
        <translation>Fotos y lo que añaden</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>One row per photograph with the ground that it shows and, if it is needed, its place in the selection.</source>
        <translation>Una fila por fotografía con el terreno que muestra y, si es necesaria, su puesto en la selección.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Share of the area seen by at least one</source>
        <translation>Parte del área que muestra al menos una</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Number of cells that no photo sees</source>
        <translation>Número de celdas que ninguna foto muestra</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>Fewest photos that see all that the collection sees</source>
        <translation>Menos fotos que muestran todo lo que muestra la colección</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>No smaller choice exists</source>
        <translation>No existe una elección menor</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>None of the points is an oriented photo of a chosen status on this DEM.</source>
        <translation>Ninguno de los puntos es una foto orientada con un estado elegido sobre este MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_coverage.py"/>
        <source>The area is empty, or lies outside the region for which the DEM's CRS is valid.</source>
        <translation>El área está vacía o se halla fuera de la región en la que es válido el SRC del MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>photo,viewshed,heading,orientation,skyline,visibility,heic,exif,report,batch</source>
        <translation>foto,cuenca visual,rumbo,orientación,línea del horizonte,visibilidad,HEIC,EXIF,informe,lote,viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>From mountain photographs and a DEM to headings, ground in view and a report</source>
        <translation>De fotografías de montaña y un MDE a rumbos, terreno visible y un informe</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Reads geotagged photographs, finds the heading of each from its skyline and the elevation model, and computes the ground that it shows. Choose a folder or a layer of photo points.</source>
        <translation>Lee fotografías georreferenciadas, halla el rumbo de cada una a partir de su línea del horizonte y del modelo digital de elevaciones, y calcula el terreno que muestra. Elija una carpeta o una capa de puntos de fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Open the report to check each match: it has one card per photograph, with the horizon drawn over the picture. Photographs with a doubtful heading (status &lt;i&gt;ambiguous&lt;/i&gt;) get no viewshed unless you request it under Advanced. With the &lt;i&gt;paper&lt;/i&gt; method, which does not test its answers, all photographs get one.</source>
        <translation>Abra el informe para comprobar cada ajuste: contiene una ficha por fotografía, con el horizonte dibujado sobre la imagen. Las fotografías de rumbo dudoso (estado &lt;i&gt;ambiguous&lt;/i&gt;) no reciben cuenca visual a menos que la pida en Avanzado. Con el método &lt;i&gt;artículo&lt;/i&gt;, que no comprueba sus respuestas, todas las fotografías reciben una.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Distances are ground metres and headings count from true north, whatever the coordinate systems.</source>
        <translation>Las distancias son metros sobre el terreno y los rumbos parten del norte geográfico, sean cuales sean los sistemas de coordenadas.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Maximum viewshed distance from the camera, in metres on the ground.</source>
        <translation>Distancia máxima de la cuenca visual desde la cámara, en metros sobre el terreno.</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Viewsheds of doubtful photos too</source>
        <translation>Cuencas visuales también de las fotos dudosas</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Search range of the horizon (m)</source>
        <translation>Alcance de búsqueda del horizonte (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/photo_viewshed.py"/>
        <source>Computes the ground for the best heading even if another heading is as likely.</source>
        <translation>Calcula el terreno para el mejor rumbo aunque otro rumbo sea igual de probable.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Pixels to map (monoplotting)</source>
        <translation>De los píxeles al mapa (monoplotting)</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>monoplotting,pixel,photo,georeference,digitise,glacier,labelme,coco,via,ellipse,accuracy</source>
        <translation>monoplotting,píxel,foto,georreferenciar,digitalizar,glaciar,LabelMe,COCO,VIA,elipse,exactitud</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Points, lines and areas drawn on oriented photos become map features with an error ellipse</source>
        <translation>Los puntos, líneas y áreas dibujados sobre fotos orientadas se convierten en objetos del mapa con una elipse de error</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Follows the line of sight of each pixel to the elevation model, with the earth's curvature and refraction. Lines and outlines are followed pixel by pixel and cut where the ground behind them jumps. If a pixel shows the sky, or its line of sight enters a void of the DEM or reaches its edge, the field &lt;b&gt;status&lt;/b&gt; records this.</source>
        <translation>Sigue la línea de visión de cada píxel hasta el modelo digital de elevaciones, con la curvatura terrestre y la refracción. Líneas y contornos se siguen píxel a píxel y se cortan donde salta el terreno de detrás. Si un píxel muestra el cielo, o su línea de visión entra en un vacío del MDE o llega a su borde, el campo &lt;b&gt;status&lt;/b&gt; lo indica.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>The error ellipse contains the true position with the chosen probability, given the uncertainties of heading, pitch, roll, focal length, position and DEM. &lt;b&gt;p_other&lt;/b&gt; is the probability that the pixel shows different ground, beyond an edge in the picture. It is often large near ridges.</source>
        <translation>La elipse de error contiene la posición verdadera con la probabilidad elegida, dadas las incertidumbres de rumbo, cabeceo, alabeo, distancia focal, posición y MDE. &lt;b&gt;p_other&lt;/b&gt; es la probabilidad de que el píxel muestre otro terreno, más allá de un borde en la imagen. Suele ser grande cerca de las crestas.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Probability of the error ellipse (%)</source>
        <translation>Probabilidad de la elipse de error (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Probability that the ellipse contains the true position; 90 % is usual.</source>
        <translation>Probabilidad de que la elipse contenga la posición verdadera; el 90 % es lo habitual.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Lines and outlines are followed in steps of this length.</source>
        <translation>Las líneas y los contornos se siguen en pasos de esta longitud.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Points on the map</source>
        <translation>Puntos en el mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Where the lines of sight of drawn points meet the ground, with status and distance (m).</source>
        <translation>Donde las líneas de visión de los puntos dibujados encuentran el terreno, con estado y distancia (m).</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Lines on the map</source>
        <translation>Líneas en el mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Drawn lines on the ground, cut where the ground behind them jumps.</source>
        <translation>Líneas dibujadas, sobre el terreno, cortadas donde el terreno tras ellas salta.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Areas on the map</source>
        <translation>Áreas en el mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Drawn areas on the ground.</source>
        <translation>Áreas dibujadas, sobre el terreno.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Error ellipses</source>
        <translation>Elipses de error</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>One ellipse per point, which contains the true position with the chosen probability.</source>
        <translation>Una elipse por punto, que contiene la posición verdadera con la probabilidad elegida.</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Number of map features</source>
        <translation>Número de objetos del mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/pixel_to_map.py"/>
        <source>Number of features that show no ground</source>
        <translation>Número de objetos que no muestran terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Check photo positions</source>
        <translation>Comprobar posiciones de fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>position,gps,check,wrong,shift,photo,skyline,horizon,quality</source>
        <translation>posición,gps,comprobar,error,desplazamiento,foto,línea del horizonte,horizonte,calidad</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Whether the recorded position of a photo agrees with its skyline, and where a better place is</source>
        <translation>Si la posición registrada de una foto concuerda con su línea del horizonte, y dónde hay un lugar mejor</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Orients each photograph from its recorded position and then tries places around it. If the skyline fits much better somewhere else, &lt;b&gt;verdict&lt;/b&gt; is &lt;i&gt;doubtful&lt;/i&gt;, and &lt;b&gt;dx&lt;/b&gt; and &lt;b&gt;dy&lt;/b&gt; give the way there in metres to the east and north. Positions are reported and never changed.</source>
        <translation>Orienta cada fotografía desde su posición registrada y después prueba lugares alrededor. Si la línea del horizonte encaja mucho mejor en otro sitio, &lt;b&gt;verdict&lt;/b&gt; es &lt;i&gt;doubtful&lt;/i&gt;, y &lt;b&gt;dx&lt;/b&gt; y &lt;b&gt;dy&lt;/b&gt; dan el camino hasta allí en metros hacia el este y el norte. Las posiciones se señalan y nunca se cambian.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>A skyline of far mountains says little about a position: a &lt;i&gt;believable&lt;/i&gt; verdict only means that no place nearby fits much better. The error ellipse says how well the skyline fixes the better place.</source>
        <translation>Una línea del horizonte de montañas lejanas dice poco de una posición: un veredicto &lt;i&gt;believable&lt;/i&gt; solo significa que ningún lugar cercano encaja mucho mejor. La elipse de error dice con qué exactitud fija la línea del horizonte el lugar mejor.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Rings of places are tried out to this distance; the larger it is, the farther apart they lie.</source>
        <translation>Se prueban anillos de lugares hasta esta distancia; cuanto mayor es, más separados están.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Search radius (m)</source>
        <translation>Radio de búsqueda (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Checked positions</source>
        <translation>Posiciones comprobadas</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>The photo points with the verdict and the way to the better place.</source>
        <translation>Los puntos de las fotos con el veredicto y el camino al lugar mejor.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Number of doubtful positions</source>
        <translation>Número de posiciones dudosas</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Better place, metres to the east</source>
        <translation>Lugar mejor, metros hacia el este</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Better place, metres to the north</source>
        <translation>Lugar mejor, metros hacia el norte</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <source>Gain in agreement there</source>
        <translation>Ganancia de concordancia allí</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Error ellipse (90 %), longer half axis (m)</source>
        <translation>Elipse de error (90 %), semieje mayor (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Error ellipse (90 %), shorter half axis (m)</source>
        <translation>Elipse de error (90 %), semieje menor (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_check.py"/>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Azimuth of the longer half axis (°)</source>
        <translation>Acimut del semieje mayor (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Position photos from a track</source>
        <translation>Situar fotos a partir de un track</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>photo,gps,gpx,track,time,clock,geotag,position,exif,time zone</source>
        <translation>foto,gps,gpx,track,hora,reloj,geoetiqueta,posición,exif,zona horaria</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Points of photographs without GPS, from the times of a recorded track</source>
        <translation>Puntos de fotografías sin GPS, a partir de las horas de un track grabado</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Makes one point per photograph at the place of the track at the photograph's time. The point's error (&lt;b&gt;pos_err&lt;/b&gt;) grows with the gap between the track points around it; &lt;i&gt;Orient photos&lt;/i&gt; takes it into account. If the track gives no position for that time, the point has no geometry and &lt;b&gt;pos_note&lt;/b&gt; says why.</source>
        <translation>Crea un punto por fotografía en el lugar del track a la hora de la fotografía. El error del punto (&lt;b&gt;pos_err&lt;/b&gt;) crece con el intervalo entre los puntos del track que lo rodean; &lt;i&gt;Orientar fotos&lt;/i&gt; lo tiene en cuenta. Si el track no da una posición para esa hora, el punto no tiene geometría y &lt;b&gt;pos_note&lt;/b&gt; indica el motivo.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Cameras record local time. The time zone is read from the file, or taken from the parameter. If the clock was wrong, give its offset, or have it found &lt;i&gt;from the skylines&lt;/i&gt;: this needs an elevation model and at least three photographs with a clear skyline from different places, and takes a few minutes. If other offsets fit as well, no photograph is placed and a warning says so.</source>
        <translation>Las cámaras registran la hora local. La zona horaria se lee del archivo o se toma del parámetro. Si el reloj iba mal, indique su desfase o haga que se determine &lt;i&gt;a partir de las líneas del horizonte&lt;/i&gt;: para ello se necesitan un modelo de elevación y al menos tres fotografías con una línea del horizonte clara desde lugares distintos, y tarda unos minutos. Si otros desfases encajan igual de bien, no se sitúa ninguna fotografía y un aviso lo indica.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>JPEG and HEIC files; a GPS position is not needed.</source>
        <translation>Archivos JPEG y HEIC; no se necesita posición GPS.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Layer or table with the paths of the photographs, in place of a folder.</source>
        <translation>Capa o tabla con las rutas de las fotografías, en lugar de una carpeta.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Time zone of the camera's clock</source>
        <translation>Zona horaria del reloj de la cámara</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>For example +05:45 or Asia/Kathmandu. Empty: as the photograph records it.</source>
        <translation>Por ejemplo +05:45 o Asia/Kathmandu. Vacío: la que registra la fotografía.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Camera's clock</source>
        <translation>Reloj de la cámara</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>as given</source>
        <translation>según lo indicado</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>find its offset from the skylines</source>
        <translation>determinar su desfase a partir de las líneas del horizonte</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The skylines show where the photographs were taken, and so how much the clock is ahead: up to 14 hours to either side. At most 20 photographs are used, spread over the walk and at least a minute apart.</source>
        <translation>Las líneas del horizonte muestran dónde se tomaron las fotografías y, con ello, cuánto adelanta el reloj: hasta 14 horas en ambos sentidos. Se usan como máximo 20 fotografías, repartidas por el recorrido y separadas al menos un minuto.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Seconds by which the camera's clock is ahead of the true time; negative if it is behind.</source>
        <translation>Segundos que el reloj de la cámara adelanta respecto a la hora verdadera; negativo si atrasa.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Clock is ahead by (s)</source>
        <translation>El reloj adelanta (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Needed only to find the clock's offset from the skylines.</source>
        <translation>Solo se necesita para determinar el desfase del reloj a partir de las líneas del horizonte.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Longest time between two track points that is interpolated; beyond the track's ends, half of it.</source>
        <translation>Tiempo máximo entre dos puntos del track que se interpola; más allá de sus extremos, la mitad.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Interpolation limit (s)</source>
        <translation>Límite de interpolación (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Standard deviation of the track's points.</source>
        <translation>Desviación estándar de los puntos del track.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Error of the track (m)</source>
        <translation>Error del track (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>One point per photograph, with the source of its position and its error; without geometry if there is no position.</source>
        <translation>Un punto por fotografía, con el origen de su posición y su error; sin geometría si no hay posición.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Positioned photos</source>
        <translation>Fotos situadas</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Number of photos with a position</source>
        <translation>Número de fotos con posición</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Offset of the clock that was used (s)</source>
        <translation>Desfase del reloj que se utilizó (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Standard deviation of the clock's offset (s)</source>
        <translation>Desviación estándar del desfase del reloj (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Choose either a folder of photographs or a layer with their paths.</source>
        <translation>Elija una carpeta de fotografías o una capa con sus rutas, pero no ambas.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>To find the clock's offset from the skylines, choose an elevation model.</source>
        <translation>Para determinar el desfase del reloj a partir de las líneas del horizonte, elija un modelo de elevación.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>{placed} of {count} photos have a position.</source>
        <translation>{placed} de {count} fotos tienen posición.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The photo records no time.</source>
        <translation>La foto no registra ninguna hora.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>The photo records no time zone. Give the time zone of the camera's clock.</source>
        <translation>La foto no registra la zona horaria. Indique la zona horaria del reloj de la cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>from the track</source>
        <translation>del track</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Time between the track points around the photo (s)</source>
        <translation>Tiempo entre los puntos del track que rodean la foto (s)</translation>
    </message>
    <message>
        <location filename="../algorithms/position_photos.py"/>
        <source>Where the position comes from, or why there is none</source>
        <translation>De dónde procede la posición, o por qué no la hay</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>One row per device, from accepted and confirmed photos: bias of the compass with its 90 % interval, spread, worthless and turned readings, and drift over the day.</source>
        <translation>Una fila por dispositivo, de las fotos aceptadas y confirmadas: sesgo de la brújula con su intervalo del 90 %, dispersión, lecturas inservibles y giradas, y deriva a lo largo del día.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Compass audit</source>
        <translation>Auditoría de brújulas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Maker, model and software</source>
        <translation>Fabricante, modelo y software</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <location filename="../core/report/compass.py"/>
        <source>Readings</source>
        <translation>Lecturas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Recorded minus found heading, median (°)</source>
        <translation>Rumbo registrado menos rumbo hallado, mediana (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Lower limit of the bias, 90 % (°)</source>
        <translation>Límite inferior del sesgo, 90 % (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Upper limit of the bias, 90 % (°)</source>
        <translation>Límite superior del sesgo, 90 % (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Robust standard deviation (°)</source>
        <translation>Desviación típica robusta (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings off by more than 30°</source>
        <translation>Lecturas desviadas más de 30°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias + 90°</source>
        <translation>Lecturas cerca del sesgo + 90°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias − 90°</source>
        <translation>Lecturas cerca del sesgo − 90°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Readings near bias + 180°</source>
        <translation>Lecturas cerca del sesgo + 180°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Too many of these for chance</source>
        <translation>Demasiadas de estas para ser casualidad</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Change of the bias during a day (° per hour)</source>
        <translation>Cambio del sesgo durante un día (° por hora)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Lower limit of the change, 90 % (° per hour)</source>
        <translation>Límite inferior del cambio, 90 % (° por hora)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_audit.py"/>
        <source>Upper limit of the change, 90 % (° per hour)</source>
        <translation>Límite superior del cambio, 90 % (° por hora)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <source>{count} photos are oriented first to test the compasses of the cameras.</source>
        <translation>Primero se orientan {count} fotos para comprobar las brújulas de las cámaras.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Cancelled after {done} of {count} photos.</source>
        <translation>Cancelado tras {done} de {count} fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/compass_sample.py"/>
        <source>{camera}: about {percent} % of the compass readings are treated as worthless, because they contradict the skylines.</source>
        <translation>{camera}: cerca del {percent} % de las indicaciones de la brújula se consideran inútiles, porque contradicen las líneas del horizonte.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photo point</source>
        <translation>Punto de foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Cells of the area that it sees</source>
        <translation>Celdas del área que muestra</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Share of the area that it sees</source>
        <translation>Parte del área que muestra</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Place among the fewest photos needed; NULL: not needed</source>
        <translation>Puesto entre las menos fotos necesarias; NULL: no necesaria</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Cells that it adds to those picked before</source>
        <translation>Celdas que añade a las elegidas antes</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>Share of the area seen by the picks up to here</source>
        <translation>Parte del área que muestran las elegidas hasta aquí</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>photographs that see the cell</source>
        <translation>fotografías que ven la celda</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/coverage_outputs.py"/>
        <source>metres per pixel across the view, best photo</source>
        <translation>metros por píxel a través de la vista, mejor foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>No photo shows any ground of this DEM, so there is nothing to drape.</source>
        <translation>Ninguna foto muestra terreno de este MDE: no hay nada que extender.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>red</source>
        <translation>rojo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>green</source>
        <translation>verde</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>blue</source>
        <translation>azul</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>opacity</source>
        <translation>opacidad</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>metres per pixel across the view</source>
        <translation>metros por píxel a través de la vista</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/draped_raster.py"/>
        <source>metres per pixel along the view</source>
        <translation>metros por píxel a lo largo de la vista</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/elevation.py"/>
        <source>The elevation model cannot be read. Choose a raster file with heights.</source>
        <translation>No se puede leer el modelo digital de elevaciones. Elija un archivo ráster con altitudes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/elevation.py"/>
        <source>The elevation model comes from a {provider} source. Save it as a GeoTIFF first and choose that.</source>
        <translation>El modelo digital de elevaciones procede de una fuente {provider}. Guárdelo primero como GeoTIFF y elija este.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/feedback.py"/>
        <source>{name} ({number}/{count})</source>
        <translation>{name} ({number}/{count})</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/field_names.py"/>
        <source>Fields renamed because the format of the output reserves the name: {names}</source>
        <translation>Campos renombrados porque el formato de salida reserva el nombre: {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/fields.py"/>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <source>Choose a folder of photographs or a layer of photo points.</source>
        <translation>Elija una carpeta de fotografías o una capa de puntos de fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <source>Choose either a folder of photographs or a layer of photo points, not both.</source>
        <translation>Elija o una carpeta de fotografías o una capa de puntos de fotos, no ambas.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/folder_photos.py"/>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>The folder {folder} does not exist.</source>
        <translation>La carpeta {folder} no existe.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Map feature</source>
        <translation>Objeto del mapa</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>visible, hidden, outside the frame, unknown</source>
        <translation>visible (visible), hidden (oculto), outside (fuera del encuadre), unknown (desconocido)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance from the camera (m)</source>
        <translation>Distancia a la cámara (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Elevation (m)</source>
        <translation>Altitud (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Line or ring of the feature</source>
        <translation>Línea o anillo del objeto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Begins at this share of its length</source>
        <translation>Empieza en esta parte de su longitud</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Ends at this share of its length</source>
        <translation>Termina en esta parte de su longitud</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Nearest distance (m)</source>
        <translation>Menor distancia (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Farthest distance (m)</source>
        <translation>Mayor distancia (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>Share of the whole feature that is visible</source>
        <translation>Parte visible del objeto entero</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/image_features.py"/>
        <source>The map features are empty, or lie outside the region for which the DEM's CRS is valid.</source>
        <translation>Los objetos del mapa están vacíos o se hallan fuera de la región en la que es válido el SRC del MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <source>One file per photo (about 2 MB), for this plugin only. A repeated run reuses each orientation for which nothing has changed (photo, DEM, settings, version of the plugin), so a run that was stopped continues where it stopped.</source>
        <translation>Un archivo por foto (unos 2 MB), solo para este complemento. Una ejecución repetida reutiliza cada orientación para la que nada ha cambiado (foto, MDE, ajustes, versión del complemento), de modo que una ejecución interrumpida continúa donde se detuvo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <source>Folder for finished orientations</source>
        <translation>Carpeta de orientaciones terminadas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/kept_orientations.py"/>
        <location filename="../algorithms/shared/viewer.py"/>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>{name}: taken from {path}</source>
        <translation>{name}: tomado de {path}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <location filename="../algorithms/shared/places_along.py"/>
        <source>The layer of points has no feature. Choose another, or clear the selection.</source>
        <translation>La capa de puntos no tiene ningún objeto. Elija otra o deshaga la selección.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>Point {id}</source>
        <translation>Punto {id}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The layer has no field {field} ({name}). Choose another.</source>
        <translation>La capa no tiene el campo {field} ({name}). Elija otro.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <location filename="../panel/model/photo_layer.py"/>
        <source>The point layer has no coordinate reference system. Assign the right one in the layer's properties.</source>
        <translation>La capa de puntos no tiene sistema de referencia de coordenadas. Asigne el correcto en las propiedades de la capa.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The field {field} holds pictures, not paths. Save the pictures as files and choose a field with their paths (PHOTO_FIELD).</source>
        <translation>El campo {field} contiene imágenes, no rutas. Guarde las imágenes como archivos y elija un campo con sus rutas (PHOTO_FIELD).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/layers.py"/>
        <source>The layer has no field {field}. Choose the field that holds the photographs' paths.</source>
        <translation>La capa no tiene el campo {field}. Elija el campo que contiene las rutas de las fotografías.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>outside the picture</source>
        <translation>fuera de la imagen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>accepted: trust it</source>
        <translation>aceptada: fiable</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>confirmed by a person</source>
        <translation>confirmada por una persona</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>ambiguous: look at the report</source>
        <translation>ambigua: vea el informe</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>rejected: no answer</source>
        <translation>rechazada: sin respuesta</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>failed: input at fault</source>
        <translation>fallida: entrada defectuosa</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>not seen</source>
        <translation>no visto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>1 photo</source>
        <translation>1 foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>2 photos</source>
        <translation>2 fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>3 photos</source>
        <translation>3 fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>4 to 5 photos</source>
        <translation>4 a 5 fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>6 to 10 photos</source>
        <translation>6 a 10 fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>more than 10 photos</source>
        <translation>más de 10 fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen</source>
        <translation>visto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 200 m or more too low</source>
        <translation>oculto, 200 m o más de menos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 50 m too low</source>
        <translation>oculto, 50 m de menos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>hidden, 10 m too low</source>
        <translation>oculto, 10 m de menos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>just hidden</source>
        <translation>apenas oculto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>just seen</source>
        <translation>apenas visto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen, 10 m to spare</source>
        <translation>visto, 10 m de sobra</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>seen, 100 m or more to spare</source>
        <translation>visto, 100 m o más de sobra</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>1 (open sky)</source>
        <translation>1 (cielo abierto)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <source>Answer</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/legends.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Match</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Table of lenses</source>
        <translation>Tabla de objetivos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Distortion of known lenses, for example a CSV file: fields k1 and k2 (Brown, as in OpenCV), and at least one of make, model, lens, focal (mm) and f35 (mm), as in the photos' EXIF data; empty values fit all. The row that names most of a photo is used. Values in fields k1 and k2 of the points take precedence.</source>
        <translation>Distorsión de objetivos conocidos, por ejemplo un archivo CSV: los campos k1 y k2 (Brown, como en OpenCV) y al menos uno de make, model, lens, focal (mm) y f35 (mm), como en los datos EXIF de las fotos; los valores vacíos valen para todas. Se usa la fila que más nombra de una foto. Los valores de los campos k1 y k2 de los puntos tienen prioridad.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>{count} of {total} photos take k1 and k2 from the table of lenses.</source>
        <translation>{count} de {total} fotos toman k1 y k2 de la tabla de objetivos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>No row of the table of lenses fits {count} photos, which are treated as free of distortion: {names}.</source>
        <translation>Ninguna fila de la tabla de objetivos corresponde a {count} fotos, que se tratan como libres de distorsión: {names}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Rows {first} and {second} of LENS_TABLE fit {photo} equally well. Name more of its lens in one.</source>
        <translation>Las filas {first} y {second} de LENS_TABLE corresponden igual de bien a {photo}. Nombre en una de ellas más datos de su objetivo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>no camera in the file</source>
        <translation>ninguna cámara en el archivo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Radial distortion k1</source>
        <translation>Distorsión radial k1</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Radial distortion k2</source>
        <translation>Distorsión radial k2</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>The table LENS_TABLE needs the fields k1 and k2 and at least one of make, model, lens, focal and f35; it has {fields}.</source>
        <translation>La tabla LENS_TABLE necesita los campos k1 y k2 y al menos uno de make, model, lens, focal y f35; tiene {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>The table LENS_TABLE has no row.</source>
        <translation>La tabla LENS_TABLE no tiene ninguna fila.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Rows {first} and {second} of LENS_TABLE give one lens different distortions. Delete one.</source>
        <translation>Las filas {first} y {second} de LENS_TABLE dan distorsiones distintas al mismo objetivo. Borre una.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE has no k1.</source>
        <translation>La fila {row} de LENS_TABLE no tiene k1.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE names no camera, lens or focal length that it is for.</source>
        <translation>La fila {row} de LENS_TABLE no nombra ninguna cámara, objetivo ni distancia focal a la que se aplique.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lens_table.py"/>
        <source>Row {row} of LENS_TABLE: {field} is {value}. Give one positive number for a focal length, and numbers with a decimal point for k1 and k2.</source>
        <translation>Fila {row} de LENS_TABLE: {field} es {value}. Indique un número positivo para una distancia focal y números con punto decimal para k1 y k2.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Rank</source>
        <translation>Orden</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch (°, + up)</source>
        <translation>Cabeceo (°, + hacia arriba)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Roll (°, + right side down)</source>
        <translation>Alabeo (°, + lado derecho más bajo)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Vertical field of view (°)</source>
        <translation>Ángulo de visión vertical (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../core/base/attributes.py"/>
        <source>Elevation of the camera (m)</source>
        <translation>Altitud de la cámara (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Probability that place (500 m) and heading (3°) are right</source>
        <translation>Probabilidad de que lugar (500 m) y rumbo (3°) sean correctos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Agreement of the skyline with the horizon</source>
        <translation>Concordancia de la línea del horizonte con el horizonte</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <location filename="../algorithms/shared/located_report.py"/>
        <source>Correlation of place and focal length</source>
        <translation>Correlación de lugar y distancia focal</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Distance from the recorded position (m)</source>
        <translation>Distancia a la posición registrada (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_outputs.py"/>
        <source>Area (km²)</source>
        <translation>Superficie (km²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_report.py"/>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Latitude</source>
        <translation>Latitud</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/located_report.py"/>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <location filename="../core/report/orientability.py"/>
        <source>Longitude</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/lost_crs.py"/>
        <source>QGIS has lost the definition of the layer's coordinate reference system. Set the system in the layer's properties again, or remove the layer from the project and add it again.</source>
        <translation>QGIS ha perdido la definición del sistema de referencia de coordenadas de la capa. Vuelva a asignar el sistema en las propiedades de la capa, o quite la capa del proyecto y añádala de nuevo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/map_places.py"/>
        <source>A layer has no coordinate reference system. Assign the right one in the layer's properties.</source>
        <translation>Una capa no tiene sistema de referencia de coordenadas. Asigne el correcto en las propiedades de la capa.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>What the pixel shows: ground, sky, void, beyond the DEM, outside the frame</source>
        <translation>Lo que muestra el píxel: ground (terreno), sky (cielo), void (hueco), beyond (más allá del MDE), outside (fuera de la imagen)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <location filename="../algorithms/which_photos.py"/>
        <source>Angle of incidence (°, 0 head-on)</source>
        <translation>Ángulo de incidencia (°, 0 de frente)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Ground per pixel across the view (m)</source>
        <translation>Terreno por píxel transversal a la vista (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Error ellipse, major half axis (m)</source>
        <translation>Elipse de error, semieje mayor (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Error ellipse, minor half axis (m)</source>
        <translation>Elipse de error, semieje menor (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Direction of the major axis (° from true north)</source>
        <translation>Dirección del eje mayor (° desde el norte geográfico)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Standard deviation of the elevation (m)</source>
        <translation>Desviación típica de la altitud (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Probability that the pixel shows other ground, beyond an edge</source>
        <translation>Probabilidad de que el píxel muestre otro terreno, más allá de un borde</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance, 5 % quantile (m)</source>
        <translation>Distancia, cuantil del 5 % (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Distance, 95 % quantile (m)</source>
        <translation>Distancia, cuantil del 95 % (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>What it shows: ground, partly ground, sky, void, beyond the DEM, outside the frame</source>
        <translation>Lo que muestra: ground (terreno), partly ground (terreno en parte), sky (cielo), void (hueco), beyond (más allá del MDE), outside (fuera de la imagen)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Share of its outline that lies on known ground</source>
        <translation>Parte de su contorno que está sobre terreno conocido</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Pieces, cut where the ground behind jumps</source>
        <translation>Trozos, cortados donde salta el terreno de detrás</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Median of the error ellipses' major half axis (m)</source>
        <translation>Mediana de los semiejes mayores de las elipses de error (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Largest of the error ellipses' major half axis (m)</source>
        <translation>Mayor de los semiejes mayores de las elipses de error (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Mean probability that it shows other ground, beyond an edge</source>
        <translation>Probabilidad media de que muestre otro terreno, más allá de un borde</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>Probability that the ellipse contains the true position</source>
        <translation>Probabilidad de que la elipse contenga la posición verdadera</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>The picture's size is unknown, so its pixels cannot be placed.</source>
        <translation>Se desconoce el tamaño de la imagen, por lo que sus píxeles no pueden situarse.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/monoplotting.py"/>
        <source>{count} of {total} image features reach beyond the picture of {width} x {height} pixels; nothing outside it is placed. Check that they were drawn on this picture, and not on a reduced, cropped or turned copy.</source>
        <translation>{count} de {total} objetos de imagen sobresalen de la imagen de {width} x {height} píxeles; lo que queda fuera no se sitúa. Compruebe que se dibujaron sobre esta imagen y no sobre una copia reducida, recortada o girada.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>mean probability</source>
        <translation>probabilidad media</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientability_outputs.py"/>
        <source>expected error (°)</source>
        <translation>error esperado (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Field of view of the upright picture, across its middle. NULL: computed from the focal length in the file. Fields named k1 and k2 give the distortion of the lens (Brown, as in OpenCV).</source>
        <translation>Campo de visión de la imagen derecha, por su centro. NULL: se calcula con la distancia focal del archivo. Los campos k1 y k2 dan la distorsión del objetivo (Brown, como en OpenCV).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Absolute elevation of the camera in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Altitud absoluta de la cámara en el sistema altimétrico del MDE. NULL: MDE más altura de la cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Field with the error of the position (m)</source>
        <translation>Campo con el error de la posición (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Standard deviation, as Position photos from a track writes it. NULL: a few metres, as GPS has in the open.</source>
        <translation>Desviación estándar, tal como la escribe «Situar fotos a partir de un track». NULL: unos pocos metros, como el GPS a cielo abierto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Horizontal field of view of all photos (°)</source>
        <translation>Campo de visión horizontal de todas las fotos (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>For photographs of one lens without a focal length in their files, across the middle of the upright picture. A value in the field takes precedence.</source>
        <translation>Para fotos de un mismo objetivo sin distancia focal en sus archivos, por el centro de la imagen derecha. Un valor en el campo tiene prioridad.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>Camera at the recorded altitude</source>
        <translation>Cámara a la altitud registrada</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>For towers, cable cars and drones: uses the altitude in the file, if it counts from sea level, instead of the DEM plus camera height. A phone's altitude is often wrong by 10 to 50 m. The elevation in the field with the camera's elevation takes precedence.</source>
        <translation>Para torres, teleféricos y drones: usa la altitud del archivo, si se cuenta desde el nivel del mar, en lugar del MDE más la altura de la cámara. La altitud de un teléfono suele errar entre 10 y 50 m. La altitud del campo con la altitud de la cámara tiene prioridad.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>One point per photograph with all fields of the source, then heading, pitch, roll, field of view, their uncertainty, status and message.</source>
        <translation>Un punto por fotografía con todos los campos de la fuente, después rumbo, cabeceo, alabeo, ángulo de visión, su incertidumbre, estado y mensaje.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/orientation.py"/>
        <source>{count} photos: {parts}.</source>
        <translation>{count} fotos: {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/outputs.py"/>
        <source>{path} cannot hold the fields of the photo points: {reason} Write a GeoPackage (.gpkg).</source>
        <translation>{path} no puede contener los campos de los puntos de foto: {reason} Escriba un GeoPackage (.gpkg).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/outputs.py"/>
        <source>{name} could not be written.</source>
        <translation>No se pudo escribir {name}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/panorama_files.py"/>
        <source>panorama</source>
        <translation>panorama</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photo points</source>
        <translation>Puntos de fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>One point per photograph, in any coordinate system, for example from Import geotagged photos. The point is the camera's position. If a point has no geometry, the position recorded in the photograph is used.</source>
        <translation>Un punto por fotografía, en cualquier sistema de coordenadas, por ejemplo de «Importar fotos geoetiquetadas». El punto es la posición de la cámara. Si un punto no tiene geometría, se usa la posición registrada en la fotografía.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Field with the photo's path</source>
        <translation>Campo con la ruta de la foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Full path of the photograph; a relative path counts from the layer's or the project's folder.</source>
        <translation>Ruta completa de la fotografía; una ruta relativa parte de la carpeta de la capa o del proyecto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Any raster with heights in metres and a coordinate system, projected or geographic. It should extend to the mountains that are visible.</source>
        <translation>Cualquier ráster con altitudes en metros y un sistema de coordenadas, proyectado o geográfico. Debería extenderse hasta las montañas visibles.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>DEM band</source>
        <translation>Banda del MDE</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Band that holds the heights.</source>
        <translation>Banda que contiene las altitudes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>as the file says</source>
        <translation>según el archivo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>feet (0.3048 m)</source>
        <translation>pies (0,3048 m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>US survey feet</source>
        <translation>pies topográficos de EE. UU.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>decimetres</source>
        <translation>decímetros</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/base/heights.py"/>
        <source>kilometres</source>
        <translation>kilómetros</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Unit of the heights</source>
        <translation>Unidad de las alturas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Unit of the heights in the elevation model. Many files in feet or decimetres do not say so; without any unit in the file, metres are assumed.</source>
        <translation>Unidad de las alturas del modelo de elevación. Muchos archivos en pies o decímetros no lo indican; si el archivo no da ninguna unidad, se suponen metros.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Maximum distance of the mountains on the skyline, in metres on the ground. The paper method uses at most 15 km.</source>
        <translation>Distancia máxima de las montañas de la línea del horizonte, en metros sobre el terreno. El método artículo usa como máximo 15 km.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>robust</source>
        <translation>robusto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>paper (as published)</source>
        <translation>artículo (tal como se publicó)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Robust: exact camera geometry, a search over all headings, and an error bar. Paper: the published correlation of skylines on a flat earth, for comparison; it does not use the compass, hints, landmarks, drawn skylines or masks.</source>
        <translation>Robusto: geometría exacta de la cámara, una búsqueda en todos los rumbos y un margen de error. Artículo: la correlación publicada de las líneas del horizonte sobre una tierra plana, para comparar; no usa la brújula, indicaciones, puntos de referencia, líneas del horizonte dibujadas ni máscaras.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>ignore</source>
        <translation>ignorar</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>use as a hint</source>
        <translation>usar como indicio</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Ignore: the heading is found without the compass. Hint: the compass heading is a prior, wide enough for the usual errors of phones; a clear skyline overrules it.</source>
        <translation>Ignorar: el rumbo se determina sin la brújula. Indicación: el rumbo de la brújula es una suposición previa, lo bastante amplia para los errores habituales de los teléfonos; una línea del horizonte clara se impone.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Ignore: no reading counts by itself; photos of a walk that are oriented together still compare their readings, which alone gives no heading. Hint: the compass heading is a prior, wide enough for the usual errors of phones; a clear skyline overrules it. If a camera has four or more photos, a sample of them is oriented first; if its compass often contradicts the skylines, it counts for less.</source>
        <translation>Ignorar: ninguna indicación cuenta por sí sola; las fotos de una caminata que se orientan juntas comparan de todos modos sus indicaciones, lo que por sí solo no da ningún rumbo. Indicación: el rumbo de la brújula es una suposición previa, lo bastante amplia para los errores habituales de los teléfonos; una línea del horizonte clara se impone. Si una cámara tiene cuatro fotos o más, primero se orienta una muestra de ellas; si su brújula contradice a menudo las líneas del horizonte, cuenta menos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Recorded compass heading</source>
        <translation>Rumbo de brújula registrado</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Camera height above ground (m)</source>
        <translation>Altura de la cámara sobre el terreno (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Metres above the elevation model.</source>
        <translation>Metros sobre el MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Distance from the camera in metres on the ground. Terrain beyond is ignored.</source>
        <translation>Distancia desde la cámara en metros sobre el terreno. El terreno de más allá se ignora.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Refraction coefficient</source>
        <translation>Coeficiente de refracción</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Share of the earth's curvature that refraction compensates; 0.13 is usual. The curvature itself is always applied.</source>
        <translation>Parte de la curvatura terrestre que la refracción compensa; 0,13 es lo usual. La curvatura misma se aplica siempre.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>photo frame</source>
        <translation>encuadre de la foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>heading wedge</source>
        <translation>sector de visión</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>full circle</source>
        <translation>círculo completo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photo frame: ground inside the picture, with pitch, roll and both fields of view. Heading wedge: all ground within the horizontal field of view. Full circle: all that can be seen from the place.</source>
        <translation>Encuadre de la foto: terreno dentro de la imagen, con cabeceo, alabeo y ambos ángulos de visión. Sector de visión: todo el terreno dentro del ángulo de visión horizontal. Círculo completo: todo lo que se ve desde el lugar.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>accepted</source>
        <translation>aceptada</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>confirmed</source>
        <translation>confirmada</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>ambiguous</source>
        <translation>ambigua</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <location filename="../core/report/facts.py"/>
        <source>rejected</source>
        <translation>rechazada</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photos by status</source>
        <translation>Fotos por estado</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>Photos whose field status has one of these values are used; the log counts those that are left out. Photos of a layer without this field are all used.</source>
        <translation>Se usan las fotos cuyo campo status tiene uno de estos valores; el registro cuenta las omitidas. De una capa sin este campo se usan todas las fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>HTML files (*.html)</source>
        <translation>Archivos HTML (*.html)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/parameters.py"/>
        <source>One self-contained HTML file with figures, numbers and advice for each photo or point. From 201 photos on, the file is an index with a map, filters and thumbnails, and the cards are pages in a folder beside it.</source>
        <translation>Un archivo HTML autónomo con figuras, números y consejos para cada foto o punto. A partir de 201 fotos, el archivo es un índice con mapa, filtros y miniaturas, y las fichas son páginas en una carpeta junto a él.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>without suffix</source>
        <translation>sin extensión</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>Files that were not read as photographs: {kinds}</source>
        <translation>Archivos que no se leyeron como fotos: {kinds}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/photo_attributes.py"/>
        <source>No photograph (JPEG, HEIC) was found in {folder}. Choose another folder, or include its subfolders.</source>
        <translation>No se encontró ninguna fotografía (JPEG, HEIC) en {folder}. Elija otra carpeta o incluya sus subcarpetas.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/picture_files.py"/>
        <source>The point names no photo, so there is no picture to draw on.</source>
        <translation>El punto no nombra ninguna foto, así que no hay imagen sobre la que dibujar.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/picture_files.py"/>
        <source>No installed font has all characters of {names}, so the PNG shows boxes; the SVG is right. Install a font for this script, for example a Noto Sans, and run again.</source>
        <translation>Ninguna fuente instalada tiene todos los caracteres de {names}, por lo que el PNG muestra recuadros; el SVG es correcto. Instale una fuente para esta escritura, por ejemplo una Noto Sans, y ejecute de nuevo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Image features</source>
        <translation>Objetos de la imagen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Points, lines or polygons as drawn in QGIS over the photo itself (not rotated, y negative), or in pixels of the upright picture with y counted downwards, or a table with fields x and y. A field photo names the photograph; without it the features belong to every photo.</source>
        <translation>Puntos, líneas o polígonos dibujados en QGIS sobre la propia foto (sin girar, y negativa), o en píxeles de la imagen derecha con y contada hacia abajo, o una tabla con los campos x e y. Un campo photo nombra la foto; sin él los objetos pertenecen a todas las fotos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Image features from a labelling tool</source>
        <translation>Objetos de la imagen de una herramienta de etiquetado</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Label files (*.json *.geojson *.csv);;All files (*)</source>
        <translation>Archivos de etiquetas (*.json *.geojson *.csv);;Todos los archivos (*)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>LabelMe, COCO, VIA, GeoJSON with pixel coordinates, or CSV with photo, x, y (and feature, kind, label).</source>
        <translation>LabelMe, COCO, VIA, GeoJSON con coordenadas de píxel, o CSV con photo, x, y (y feature, kind, label).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Give image features: a layer, or a file from a labelling tool.</source>
        <translation>Dé objetos de la imagen: una capa, o un archivo de una herramienta de etiquetado.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>The image features are empty: draw something on a photo first.</source>
        <translation>Los objetos de la imagen están vacíos: dibuje primero algo sobre una foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>The image features have neither a geometry in pixels nor fields x and y; they have {fields}.</source>
        <translation>Los objetos de la imagen no tienen ni geometría en píxeles ni los campos x e y; tienen {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Several photos have these names, so the features were left out: {names}. Write the folders too, for example day1/IMG_0001.jpg.</source>
        <translation>Varias fotos tienen estos nombres, por lo que los objetos se omitieron: {names}. Escriba también las carpetas, por ejemplo day1/IMG_0001.jpg.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>No oriented photo point for: {names}</source>
        <translation>No hay punto de foto orientada para: {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/pixel_input.py"/>
        <source>Its features were drawn on a file of {bytes} bytes, which is another copy of this photo. If that copy is reduced, they are in the wrong place.</source>
        <translation>Sus objetos se dibujaron sobre un archivo de {bytes} bytes, que es otra copia de esta foto. Si esa copia está reducida, están en un lugar equivocado.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/previews.py"/>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/reporting.py"/>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/reporting.py"/>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Field with the tolerance of that heading (°)</source>
        <translation>Campo con la tolerancia de ese rumbo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>How far the heading may differ from the approximate one. NULL: 20 degrees.</source>
        <translation>Cuánto puede apartarse el rumbo del aproximado. NULL: 20 grados.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Points on the map that are visible in photographs, with the fields photo, x and y (pixels of the upright picture; the first pixel is 0) and optionally elevation (m). One landmark is enough to determine the heading. If a field body says sun or moon, the pixel shows that, and no map point is needed: its direction follows from the time of the photograph.</source>
        <translation>Puntos del mapa visibles en las fotos, con los campos photo, x e y (píxeles de la imagen derecha; el primer píxel es 0) y, si se quiere, elevation (m). Un punto de referencia basta para determinar el rumbo. Si un campo body dice sun o moon, el píxel muestra el Sol o la Luna y no hace falta un punto del mapa: su dirección se deduce de la hora de la foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Drawn skylines</source>
        <translation>Líneas del horizonte dibujadas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Table with fields photo, column and row (pixels of the upright picture): the vertices of the skyline.</source>
        <translation>Tabla con los campos photo, column y row (píxeles de la imagen enderezada): los vértices de la línea del horizonte.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Folder of sky masks</source>
        <translation>Carpeta de máscaras del cielo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>Pictures named like the photographs (IMG_1.png for IMG_1.heic) in which the sky is white.</source>
        <translation>Imágenes con el nombre de las fotografías (IMG_1.png para IMG_1.heic) en las que el cielo es blanco.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>{parameter}: several photos have the name {names}. Write the folders too, for example day1/IMG_0001.jpg; put sky masks into folders of the same names.</source>
        <translation>{parameter}: varias fotos tienen el nombre {names}. Escriba también las carpetas, por ejemplo day1/IMG_0001.jpg; ponga las máscaras de cielo en carpetas con los mismos nombres.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>LANDMARKS: the field body says {value}; it may say sun or moon, or be empty.</source>
        <translation>LANDMARKS: el campo body dice {value}; puede decir sun o moon, o estar vacío.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>The table {parameter} needs the fields photo, x and y (or column and row); it has {fields}.</source>
        <translation>La tabla {parameter} necesita los campos photo, x e y (o column y row); tiene {fields}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/rescue.py"/>
        <source>The folder of sky masks {folder} does not exist.</source>
        <translation>La carpeta de máscaras del cielo {folder} no existe.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/result_figures.py"/>
        <source>PNG files with three panels: the photograph, the heading and field of view on the DEM, and the viewshed with the camera and, if the points have a timestamp, the path between the cameras.</source>
        <translation>Archivos PNG con tres paneles: la fotografía, el rumbo y el ángulo de visión sobre el MDE, y la cuenca visual con la cámara y, si los puntos tienen marca de tiempo, el camino entre las cámaras.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/result_figures.py"/>
        <source>Folder for one figure per photo</source>
        <translation>Carpeta para una figura por foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>{name}: {verdict}, heading {heading}°</source>
        <translation>{name}: {verdict}, rumbo {heading}°</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>{names} and {count} more</source>
        <translation>{names} y {count} más</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>Check these photos ({verdict}): {names}</source>
        <translation>Revise estas fotos ({verdict}): {names}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {seconds} s left</source>
        <translation>quedan unos {seconds} s</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {minutes} min left</source>
        <translation>quedan unos {minutes} min</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/run_log.py"/>
        <source>about {hours} h left</source>
        <translation>quedan unas {hours} h</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Polygons in which the photographs may have been taken.</source>
        <translation>Polígonos en los que se pueden haber tomado las fotografías.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Extent</source>
        <translation>Extensión</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Rectangle to search, if no area is given.</source>
        <translation>Rectángulo en que se busca, si no se da un área.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Radius around the recorded position (m)</source>
        <translation>Radio alrededor de la posición registrada (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Searches around the position of each photograph, if neither an area nor an extent is given.</source>
        <translation>Busca alrededor de la posición de cada fotografía, si no se da ni un área ni una extensión.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Paths</source>
        <translation>Caminos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Only places near these lines are searched, for example hiking trails and roads.</source>
        <translation>Solo se examinan lugares cercanos a estas líneas, por ejemplo senderos y carreteras.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Distance from the paths (m)</source>
        <translation>Distancia a los caminos (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Places farther from the paths are not searched. It should be at least half the spacing.</source>
        <translation>No se examinan lugares más lejanos de los caminos. Debe ser al menos la mitad de la separación.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Weights of places</source>
        <translation>Pesos de los lugares</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Raster with the relative probability that a photograph was taken at a place, for example from land cover or slope. Zero and nodata exclude a place.</source>
        <translation>Ráster con la probabilidad relativa de que se tomara una fotografía en un lugar, por ejemplo según cobertura del suelo o pendiente. Cero y nodata excluyen un lugar.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>Choose where to search: an area, an extent, or a radius around the recorded positions.</source>
        <translation>Elija dónde buscar: un área, una extensión o un radio alrededor de las posiciones registradas.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The photo has no recorded position to search around. Choose an area or an extent.</source>
        <translation>La foto no tiene posición registrada alrededor de la cual buscar. Elija un área o una extensión.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The raster of weights excludes every place of the area. Choose another.</source>
        <translation>El ráster de pesos excluye todos los lugares del área. Elija otro.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>{name} has no usable feature. Choose another layer.</source>
        <translation>{name} no tiene ningún objeto utilizable. Elija otra capa.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/search_area.py"/>
        <source>The area is empty. Choose a larger one, or a larger distance from the paths.</source>
        <translation>El área está vacía. Elija una mayor, o una distancia mayor a los caminos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Extent of the sky view raster</source>
        <translation>Extensión del ráster de visión del cielo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Sky view factor of every cell of the DEM in the extent, its slope taken into account (1 = open sky).</source>
        <translation>Factor de visión del cielo de cada celda del MDE en la extensión, con su pendiente (1 = cielo abierto).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Empty: the whole DEM. A million cells take some ten seconds.</source>
        <translation>Vacío: todo el MDE. Un millón de celdas tarda unos diez segundos.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Search range of the sky view raster (m)</source>
        <translation>Alcance de búsqueda del ráster de visión del cielo (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>Terrain beyond is ignored; distant mountains cover little of the sky.</source>
        <translation>El terreno de más allá se ignora; las montañas lejanas cubren poco cielo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Sky view factor</source>
        <translation>Factor de visión del cielo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>The extent of the sky view raster does not overlap the DEM. Choose another.</source>
        <translation>La extensión del ráster de visión del cielo no se solapa con el MDE. Elija otra.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>The search range of the sky view raster can be at most {most} m on a DEM with cells of {cell} m.</source>
        <translation>El alcance de búsqueda del ráster de visión del cielo puede ser de {most} m como máximo con un MDE de celdas de {cell} m.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/sky_view_output.py"/>
        <source>sky view factor</source>
        <translation>factor de visión del cielo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Skylines of the photographs</source>
        <translation>Líneas de horizonte de las fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Table of Extract skyline (photo, column, row, confidence). Ground that would appear above its photo's skyline is hidden by something that is not in the DEM, such as trees or houses, and counts as not seen. Columns with a confidence below 0.5 exclude nothing. Requires the area photo frame.</source>
        <translation>Tabla de Extraer la línea del horizonte (photo, column, row, confidence). El terreno que aparecería por encima de la línea del horizonte de su foto está oculto por algo que no está en el MDE, como árboles o casas, y cuenta como no visto. Las columnas con una confianza inferior a 0,5 no excluyen nada. Requiere el área encuadre de la foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Foreground hides ground</source>
        <translation>El primer plano oculta terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Ground that would appear above the photograph's own skyline is hidden by something that is not in the DEM, such as trees or houses, and counts as not seen. Requires the area photo frame.</source>
        <translation>El terreno que aparecería por encima de la línea del horizonte de la propia foto está oculto por algo que no está en el MDE, como árboles o casas, y cuenta como no visto. Requiere el área encuadre de la foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Tolerance above the skyline (°)</source>
        <translation>Tolerancia sobre la línea del horizonte (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>Ground up to this angle above the skyline still counts as seen, which allows for errors of the DEM and the heading.</source>
        <translation>El terreno hasta este ángulo sobre la línea del horizonte aún cuenta como visto, lo que tiene en cuenta los errores del MDE y del rumbo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>The table of skylines has no field {field}. Choose the table that Extract skyline has written.</source>
        <translation>La tabla de líneas del horizonte no tiene el campo {field}. Elija la tabla que escribió Extraer la línea del horizonte.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/skyline_limits.py"/>
        <source>The table of skylines does not contain this photo, so no ground is excluded.</source>
        <translation>La tabla de líneas del horizonte no contiene esta foto, por lo que no se excluye ningún terreno.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>{count} of {total} photos get no viewshed because of their status: {parts}.</source>
        <translation>{count} de {total} fotos no reciben cuenca visual a causa de su estado: {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Their headings are doubtful: check them in the report. To compute their viewsheds all the same, tick "Viewsheds of doubtful photos too" under Advanced (parameter DOUBTFUL).</source>
        <translation>Sus rumbos son dudosos: compruébelos en el informe. Para calcular aun así sus cuencas visuales, marque «Cuencas visuales también de las fotos dudosas» en Avanzado (parámetro DOUBTFUL).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>{count} of {total} photos are left out because of their status: {parts}.</source>
        <translation>{count} de {total} fotos se omiten a causa de su estado: {parts}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>No photo is used, so the result is empty. {reason}</source>
        <translation>No se usa ninguna foto, por lo que el resultado está vacío. {reason}</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Their headings are doubtful: check them in the report. To use them all the same, tick their statuses in "Photos by status" under Advanced (parameter STATUSES).</source>
        <translation>Sus rumbos son dudosos: compruébelos en el informe. Para usarlas de todos modos, marque sus estados en «Fotos por estado», en Avanzado (parámetro STATUSES).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/statuses.py"/>
        <source>Photos with the status failed have no heading and cannot be used.</source>
        <translation>Las fotos con el estado failed no tienen rumbo y no se pueden usar.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/stored_style.py"/>
        <source>Style of the Skyline Viewshed plugin</source>
        <translation>Estilo del complemento Skyline Viewshed</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/stored_style.py"/>
        <source>Other fields</source>
        <translation>Otros campos</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <location filename="../panel/view/actions.py"/>
        <source>Summits</source>
        <translation>Cimas</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Points with names and heights, or an OpenStreetMap extract on your disk (.osm, .osm.pbf), of which the summits are read. Empty: summits are found in the DEM by their prominence.</source>
        <translation>Puntos con nombres y alturas, o un extracto de OpenStreetMap en su disco (.osm, .osm.pbf), del que se leen las cumbres. Vacío: las cumbres se buscan en el MDE por su prominencia.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Summits without a name are left out.</source>
        <translation>Las cimas sin nombre se dejan fuera.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Text such as 4478, 4478 m or 14692 ft is read too. Heights that the DEM contradicts are not used.</source>
        <translation>También se lee texto como 4478, 4478 m o 14692 ft. Las alturas que el MDE contradice no se usan.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Minimum prominence (m)</source>
        <translation>Prominencia mínima (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Prominence of the summits that are found in the DEM.</source>
        <translation>Prominencia de las cimas que se hallan en el MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Field with heights (m)</source>
        <translation>Campo con las altitudes (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>Search radius around a published summit (m)</source>
        <translation>Radio de búsqueda alrededor de una cima publicada (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>0: use the published position.</source>
        <translation>0: usar la posición publicada.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM is used. The point may lie beside its summit: move it, or enlarge SNAP.</source>
        <translation>La altura publicada de {height} m contradice el MDE ({top} m allí), por lo que se usa la altura del MDE. Quizá el punto esté al lado de su cumbre: muévalo o aumente SNAP.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The published height of {height} m contradicts the DEM ({top} m there), so the height of the DEM is used. If it is in feet, write 'ft' after it.</source>
        <translation>La altura publicada de {height} m contradice el MDE ({top} m allí), por lo que se usa la altura del MDE. Si está en pies, escriba 'ft' detrás.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/summit_input.py"/>
        <source>The layer of summits has no field {field}. Choose the field with the names.</source>
        <translation>La capa de cimas no tiene el campo {field}. Elija el campo con los nombres.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Orient the photos of a walk together</source>
        <translation>Orientar juntas las fotos de una caminata</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>The photos help one another: by features in common within 200 m (needs OpenCV), by the error of the compass, which one device shares for an hour, and by the focal length of their lens. Probability, interval and status then hold for all photos together. Accepted answers stay unless the others contradict them. A compass never gives a heading by itself. More than 300 photos are solved in blocks of 300, in the order of the layer; photos of different blocks do not help one another. The paper method ignores this.</source>
        <translation>Las fotos se ayudan unas a otras: por detalles comunes a menos de 200 m (requiere OpenCV), por el error de la brújula, que un dispositivo mantiene durante una hora, y por la distancia focal de su objetivo. Probabilidad, intervalo y estado valen entonces para todas las fotos juntas. Los resultados aceptados se conservan salvo que las demás los contradigan. Una brújula nunca da un rumbo por sí sola. Más de 300 fotos se resuelven en bloques de 300, en el orden de la capa; las fotos de bloques distintos no se ayudan. El método del artículo no lo tiene en cuenta.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Photographs taken near one another or with one camera help one another, so a photograph may get a different answer in a group than alone. To orient each one by itself, turn off &lt;i&gt;Orient the photos of a walk together&lt;/i&gt; (Advanced).</source>
        <translation>Las fotos tomadas cerca unas de otras o con una misma cámara se ayudan entre sí, así que una foto puede tener en un grupo otro resultado que sola. Para orientar cada una por separado, desactive &lt;i&gt;Orientar juntas las fotos de una caminata&lt;/i&gt; (Avanzado).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Cancelled while the photos were solved together.</source>
        <translation>Cancelado mientras las fotos se resolvían juntas.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>The photos could not be solved together, so each keeps its own answer.</source>
        <translation>Las fotos no se pudieron resolver juntas; cada una conserva su propio resultado.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>{count} photos gained from their neighbours.</source>
        <translation>{count} fotos mejoraron gracias a sus vecinas.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Photographs that help one another</source>
        <translation>Fotografías que se ayudan entre sí</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/together.py"/>
        <source>Without OpenCV 4.4 or newer the photos are not compared by common features.</source>
        <translation>Sin OpenCV 4.4 o posterior, las fotos no se comparan por sus rasgos comunes.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Track (GPX file)</source>
        <translation>Track (archivo GPX)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>A recorded track with times. Choose either a file or a layer.</source>
        <translation>Un track grabado con horas. Elija un archivo o una capa.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Track (layer)</source>
        <translation>Track (capa)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Points with a time, or lines whose M values are seconds since 1970 (UTC).</source>
        <translation>Puntos con una hora, o líneas cuyos valores M son segundos desde 1970 (UTC).</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Field with the time</source>
        <translation>Campo con la hora</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Date and time of each track point; without a time zone they count as UTC. Empty: a field named time.</source>
        <translation>Fecha y hora de cada punto del track; sin zona horaria se consideran UTC. Vacío: un campo llamado time.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>Choose the track: either a GPX file or a layer.</source>
        <translation>Elija el track: un archivo GPX o una capa.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>The lines of the track have no M values with times. Choose a layer of points, or a GPX file.</source>
        <translation>Las líneas del track no tienen valores M con horas. Elija una capa de puntos o un archivo GPX.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/track_input.py"/>
        <source>The track has no field with times. Choose the field that holds them.</source>
        <translation>El track no tiene ningún campo con horas. Elija el campo que las contiene.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewer.py"/>
        <source>Cancelled after {done} of {count} viewsheds.</source>
        <translation>Cancelado tras {done} de {count} cuencas visuales.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Up is positive. NULL: 0.</source>
        <translation>Positivo hacia arriba. NULL: 0.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Only used if the photograph itself is missing.</source>
        <translation>Solo se usa si falta la propia fotografía.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Absolute, in the DEM's height system. NULL: DEM plus camera height.</source>
        <translation>Absoluta, en el sistema altimétrico del MDE. NULL: MDE más altura de la cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the heading (°)</source>
        <translation>Incertidumbre del rumbo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no heading_lo and heading_hi.</source>
        <translation>Desviación típica, usada si los puntos no tienen heading_lo y heading_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the pitch (°)</source>
        <translation>Incertidumbre del cabeceo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no pitch_lo and pitch_hi.</source>
        <translation>Desviación típica, usada si los puntos no tienen pitch_lo ni pitch_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the roll (°)</source>
        <translation>Incertidumbre del alabeo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no roll_lo and roll_hi.</source>
        <translation>Desviación típica, usada si los puntos no tienen roll_lo ni roll_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the focal length (%)</source>
        <translation>Incertidumbre de la distancia focal (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation, used if the points have no hfov_lo and hfov_hi.</source>
        <translation>Desviación típica, usada si los puntos no tienen hfov_lo ni hfov_hi.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the position (m)</source>
        <translation>Incertidumbre de la posición (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation of the camera's position, in east and in north. A field h_acc takes precedence.</source>
        <translation>Desviación típica de la posición de la cámara, al este y al norte. Un campo h_acc tiene prioridad.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Uncertainty of the camera's elevation (m)</source>
        <translation>Incertidumbre de la altitud de la cámara (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Standard deviation.</source>
        <translation>Desviación típica.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>Vertical error of the DEM (m)</source>
        <translation>Error vertical del MDE (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The picture's size is unknown, so a width of 4000 px is assumed.</source>
        <translation>Se desconoce el tamaño de la imagen, por lo que se supone una anchura de 4000 px.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The photo has no horizontal field of view between 0 and 180 degrees; orient it first.</source>
        <translation>La foto no tiene un ángulo de visión horizontal entre 0 y 180 grados; oriéntela primero.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/views.py"/>
        <source>The photo has no heading; orient it first.</source>
        <translation>La foto no tiene rumbo; oriéntela primero.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Smallest area (m²)</source>
        <translation>Superficie mínima (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Smaller parts of a polygon are removed, and smaller holes are filled. 0 keeps everything.</source>
        <translation>Las partes menores de un polígono se eliminan y los huecos menores se rellenan. 0 conserva todo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Folder for layers per photo</source>
        <translation>Carpeta para capas por foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>One float GeoTIFF per photo with named bands: distance (m), elevation angle (°), height above the line of sight (m; if negative, a target must be this much higher to be visible) and, if the pose is known, column and row in the picture (px). Nodata outside the area and range.</source>
        <translation>Un GeoTIFF de coma flotante por foto con bandas con nombre: distancia (m), ángulo de elevación (°), altura sobre la línea de visión (m; si es negativa, un objetivo debe ser más alto en esa medida para ser visible) y, si se conoce la orientación, columna y fila en la imagen (px). Sin datos fuera del área y del alcance.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Folder for probabilities per photo</source>
        <translation>Carpeta para probabilidades por foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>One GeoTIFF per photo with the probability (0 to 1) that the picture shows a cell, given the intervals of the pose and the errors below. Requires the area photo frame, and takes about five times as long.</source>
        <translation>Un GeoTIFF por foto con la probabilidad (0 a 1) de que la imagen muestre una celda, dados los intervalos de la orientación y los errores de abajo. Requiere el área encuadre de la foto y tarda unas cinco veces más.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of positions (m)</source>
        <translation>Error de las posiciones (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation along each axis, for probabilities.</source>
        <translation>Desviación típica en cada eje, para las probabilidades.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the DEM (m)</source>
        <translation>Error del MDE (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation of a cell's height relative to the terrain in front of it, for probabilities.</source>
        <translation>Desviación típica de la altura de una celda respecto al terreno que tiene delante, para las probabilidades.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the pitch (°)</source>
        <translation>Error del cabeceo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its pitch.</source>
        <translation>Desviación típica, para las probabilidades. Se usa si la foto no tiene intervalo del cabeceo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the roll (°)</source>
        <translation>Error del alabeo (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its roll. It mainly affects ground far from the picture's centre.</source>
        <translation>Desviación típica, para las probabilidades. Se usa si la foto no tiene intervalo del alabeo. Afecta sobre todo al terreno alejado del centro de la imagen.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Error of the focal length (%)</source>
        <translation>Error de la distancia focal (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Standard deviation, for probabilities. Used if the photo has no interval of its field of view.</source>
        <translation>Desviación típica, para las probabilidades. Se usa si la foto no tiene intervalo del ángulo de visión.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Share of the picture that the DEM explains as ground</source>
        <translation>Parte de la imagen que el MDE explica como terreno</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Ground shown with a probability of 0.9 or more (m²)</source>
        <translation>Terreno mostrado con probabilidad de 0,9 o más (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>Ground shown with a probability of 0.5 or more (m²)</source>
        <translation>Terreno mostrado con probabilidad de 0,5 o más (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>elevation angle</source>
        <translation>ángulo de elevación</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>height above the line of sight</source>
        <translation>altura sobre la línea de visión</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>column in the photograph</source>
        <translation>columna en la foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>row in the photograph</source>
        <translation>fila en la foto</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>No layers and probabilities: the area has more than {count} million cells. Take a shorter maximum distance.</source>
        <translation>Sin capas ni probabilidades: el área tiene más de {count} millones de celdas. Elija una distancia máxima menor.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>No probabilities: they need the area photo frame, with pitch and vertical field of view.</source>
        <translation>Sin probabilidades: necesitan el área encuadre de la foto, con cabeceo y campo de visión vertical.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_extras.py"/>
        <source>probability that the photograph shows the cell</source>
        <translation>probabilidad de que la foto muestre la celda</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Farthest ground in view</source>
        <translation>Terreno visible más lejano</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>The polygon of {name} could not be built.</source>
        <translation>No se pudo formar el polígono de {name}.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Ground in view (m²)</source>
        <translation>Terreno visible (m²)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/viewshed_outputs.py"/>
        <source>Farthest ground in view (m)</source>
        <translation>Terreno visible más lejano (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Target height above ground (m)</source>
        <translation>Altura del objetivo sobre el terreno (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Height of the target; 0 means the ground itself.</source>
        <translation>Altura del objetivo; 0 significa el propio suelo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Ground nearer than this does not count as seen, but it still hides the terrain behind it.</source>
        <translation>El terreno más cercano no cuenta como visto, pero aun así oculta el terreno de detrás.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>The minimum distance must be smaller than the maximum distance.</source>
        <translation>La distancia mínima debe ser menor que la distancia máxima.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: the heading is unknown.</source>
        <translation>Sin cuenca visual: rumbo desconocido.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: the horizontal field of view is unknown.</source>
        <translation>Sin cuenca visual: ángulo de visión horizontal desconocido.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>No viewshed: a field of view must lie between 0 and 180 degrees.</source>
        <translation>Sin cuenca visual: un ángulo de visión debe estar entre 0 y 180 grados.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/visibility.py"/>
        <source>Pitch or vertical field of view is unknown: the heading wedge is shown, not the photo's frame.</source>
        <translation>Se desconoce el cabeceo o el ángulo de visión vertical: se muestra el sector de visión, no el encuadre de la foto.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>Processes that work on different photographs at the same time, each with up to 700 MB of memory. 0: all cores but one, as far as memory allows. 1: no further process. The results are the same. If QGIS finds no Python interpreter to start, a warning says so and one process does the work.</source>
        <translation>Procesos que trabajan a la vez en fotografías distintas, cada uno con hasta 700 MB de memoria. 0: todos los núcleos menos uno, en la medida en que lo permita la memoria. 1: ningún proceso adicional. Los resultados son los mismos. Si QGIS no encuentra un intérprete de Python que iniciar, un aviso lo indica y un solo proceso hace el trabajo.</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>Worker processes</source>
        <translation>Procesos de trabajo</translation>
    </message>
    <message>
        <location filename="../algorithms/shared/workers.py"/>
        <source>{count} processes share the work.</source>
        <translation>{count} procesos se reparten el trabajo.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Simulate photos</source>
        <translation>Simular fotos</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>render,view,panorama,synthetic,photo,preview,test data</source>
        <translation>renderizar,vista,panorama,sintético,foto,vista previa,datos de prueba</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Realistic photographs of the terrain from points with a heading</source>
        <translation>Fotografías realistas del terreno desde puntos con un rumbo</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Renders sun, snow, haze, sky and clouds over the elevation model and writes real JPEG or HEIC files with position, compass heading and focal length, for planning photographs, for tests and for practice.</source>
        <translation>Representa sol, nieve, calima, cielo y nubes sobre el modelo digital de elevaciones y escribe archivos JPEG o HEIC reales con posición, rumbo de brújula y distancia focal, para planear fotografías, para pruebas y para practicar.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Heading, pitch and roll come from fields (NULL: 0 for pitch and roll; points without a heading are skipped). The same seed gives the same pictures. The compass heading written is the exact one.</source>
        <translation>Rumbo, cabeceo y alabeo se toman de campos (NULL: 0 para cabeceo y alabeo; los puntos sin rumbo se omiten). La misma semilla da las mismas imágenes. El rumbo de brújula escrito es el exacto.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Points with heading</source>
        <translation>Puntos con rumbo</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Width (px)</source>
        <translation>Anchura (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Height (px)</source>
        <translation>Altura (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Size of the upright picture.</source>
        <translation>Tamaño de la imagen enderezada.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>HEIC needs the Python package pillow-heif.</source>
        <translation>HEIC necesita el paquete de Python pillow-heif.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Folder in which the pictures are saved.</source>
        <translation>Carpeta en la que se guardan las imágenes.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>The point has no usable position or no heading.</source>
        <translation>El punto no tiene una posición utilizable o no tiene rumbo.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>NULL: 65 degrees.</source>
        <translation>NULL: 65 grados.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Clouds</source>
        <translation>Nubes</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>behind the ridge</source>
        <translation>detrás de la cresta</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>lid over the ridge</source>
        <translation>tapa sobre la cresta</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>fog</source>
        <translation>niebla</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>in the valley</source>
        <translation>en el valle</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Foreground</source>
        <translation>Primer plano</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>trees</source>
        <translation>árboles</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>people</source>
        <translation>personas</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Degrees.</source>
        <translation>Grados.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of the picture's width that is covered, 0 to 1.</source>
        <translation>Parte de la anchura de la imagen que queda cubierta, 0 a 1.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Elevation. If this is empty, it is derived from the relief in view.</source>
        <translation>Altitud. Si se deja vacía, se deduce del relieve a la vista.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>The same number gives the same picture.</source>
        <translation>El mismo número da la misma imagen.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Weather of the scene.</source>
        <translation>Tiempo meteorológico de la escena.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of clouds</source>
        <translation>Parte de nubes</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Objects near the camera.</source>
        <translation>Objetos cercanos a la cámara.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Share of foreground</source>
        <translation>Parte del primer plano</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Azimuth of the sun (°)</source>
        <translation>Acimut del sol (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Elevation of the sun (°)</source>
        <translation>Ángulo de elevación del sol (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Visual range (m)</source>
        <translation>Visibilidad (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Smaller values give more haze.</source>
        <translation>Los valores menores dan más calima.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Terrain beyond is left out.</source>
        <translation>El terreno de más allá se deja fuera.</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Snow line (m)</source>
        <translation>Línea de nieve (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Tree line (m)</source>
        <translation>Límite del bosque (m)</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Sensor noise</source>
        <translation>Ruido del sensor</translation>
    </message>
    <message>
        <location filename="../algorithms/simulate_photos.py"/>
        <source>Standard deviation at mid-grey, in 8-bit steps.</source>
        <translation>Desviación típica en gris medio, en pasos de 8 bits.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Which photos show these places?</source>
        <translation>¿Qué fotos muestran estos lugares?</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>search,photo,archive,place,visible,inverse,query,resolution,ranking</source>
        <translation>búsqueda,foto,archivo,lugar,visible,inverso,consulta,resolución,clasificación</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Table of places and the photos that show them: share, pixels per metre, angle, pixel, rank</source>
        <translation>Tabla de lugares y de las fotos que los muestran: parte, píxeles por metro, ángulo, píxel, puesto</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Finds the photographs that show each point, line or area of the places layer. One row per place and photo gives the pixels per metre, the angle of incidence and the position in the picture. The best photo of each place comes first (&lt;b&gt;rank&lt;/b&gt; 1).</source>
        <translation>Halla las fotografías que muestran cada punto, línea o área de la capa de lugares. Una fila por lugar y foto da los píxeles por metro, el ángulo de incidencia y la posición en la imagen. La mejor foto de cada lugar va primero (&lt;b&gt;rank&lt;/b&gt; 1).</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>&lt;b&gt;quality&lt;/b&gt; = visible share x pixels per metre x cosine of the angle of incidence: the pixels per metre of ground in the worse direction. &lt;b&gt;place_id&lt;/b&gt; and &lt;b&gt;photo_id&lt;/b&gt; are the features' ids, which you can use for relations to both layers.</source>
        <translation>&lt;b&gt;quality&lt;/b&gt; = parte visible x píxeles por metro x coseno del ángulo de incidencia: los píxeles por metro de terreno en la peor dirección. &lt;b&gt;place_id&lt;/b&gt; y &lt;b&gt;photo_id&lt;/b&gt; son los identificadores de los objetos, que puede usar para relaciones con ambas capas.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Points, lines or areas, in any coordinate system.</source>
        <translation>Puntos, líneas o áreas, en cualquier sistema de coordenadas.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Copied to the table.</source>
        <translation>Se copia a la tabla.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Height of the target above the ground, for example of a tower or a tree top.</source>
        <translation>Altura del objetivo sobre el suelo, por ejemplo de una torre o de la copa de un árbol.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Minimum visible share (%)</source>
        <translation>Parte visible mínima (%)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photos that show less of a place are left out.</source>
        <translation>Las fotos que muestran menos de un lugar se dejan fuera.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Photos of places</source>
        <translation>Fotos de lugares</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>One row per place and photo that shows it, the best photo of each place first.</source>
        <translation>Una fila por lugar y foto que lo muestra, la mejor foto de cada lugar primero.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Number of rows</source>
        <translation>Número de filas</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Number of places that no photo shows</source>
        <translation>Número de lugares que ninguna foto muestra</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>The places layer is empty, or lies outside the region for which the DEM's CRS is valid.</source>
        <translation>La capa de lugares está vacía o se halla fuera de la región en la que es válido el SRC del MDE.</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Name of the place</source>
        <translation>Nombre del lugar</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Rank among the photos of the place</source>
        <translation>Puesto entre las fotos del lugar</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Visible share of the place</source>
        <translation>Parte visible del lugar</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Share of the place within the frame</source>
        <translation>Parte del lugar dentro del encuadre</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Column of its middle (px)</source>
        <translation>Columna de su centro (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Row of its middle (px)</source>
        <translation>Fila de su centro (px)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Azimuth from the camera (° from true north)</source>
        <translation>Acimut desde la cámara (° desde el norte geográfico)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Elevation angle from the camera (°)</source>
        <translation>Ángulo de elevación desde la cámara (°)</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Pixels per metre</source>
        <translation>Píxeles por metro</translation>
    </message>
    <message>
        <location filename="../algorithms/which_photos.py"/>
        <source>Quality: pixels per metre of ground in the worse direction</source>
        <translation>Calidad: píxeles por metro de terreno en la peor dirección</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <location filename="../panel/figures.py"/>
        <location filename="../panel/model/photo_layer.py"/>
        <source>Choose a layer of oriented photo points.</source>
        <translation>Elija una capa de puntos de fotos orientadas.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>There is no further photograph in this direction.</source>
        <translation>No hay más fotografías en esta dirección.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>No photograph without a verdict follows.</source>
        <translation>No queda más adelante ninguna fotografía sin veredicto.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>No viewshed yet: the photograph has no heading, or the elevation model is missing.</source>
        <translation>Aún no hay cuenca visual: la fotografía no tiene rumbo o falta el modelo de elevaciones.</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>Computing the viewshed ...</source>
        <translation>Calculando la cuenca visual ...</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>Opening {photo} ...</source>
        <translation>Abriendo {photo} ...</translation>
    </message>
    <message>
        <location filename="../panel/controller.py"/>
        <source>The photograph cannot be shown.</source>
        <translation>La fotografía no se puede mostrar.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Nothing to turn yet: the picture or the elevation model is missing.</source>
        <translation>Aún no hay nada que girar: falta la imagen o el modelo de elevaciones.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Click a place on the map that the middle of the picture shows.</source>
        <translation>Haga clic en el mapa en un lugar que muestre el centro de la imagen.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>No landmark yet: the picture or the elevation model is missing.</source>
        <translation>Aún no hay punto de referencia: falta la imagen o el modelo de elevaciones.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Now click the same point on the map.</source>
        <translation>Ahora haga clic en el mismo punto del mapa.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>One landmark. Set another, press Snap, or press Keep.</source>
        <translation>Un punto de referencia. Añada otro, pulse Ajustar o pulse Conservar.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>{count} landmarks. Set another, press Snap, or press Keep.</source>
        <translation>{count} puntos de referencia. Añada otro, pulse Ajustar o pulse Conservar.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>The landmarks contradict one another. Undo the last one, or check the pixels, the places on the map and the clock of the camera.</source>
        <translation>Los puntos de referencia se contradicen. Deshaga el último o compruebe los píxeles, los lugares del mapa y el reloj de la cámara.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>The map's coordinate system does not reach there.</source>
        <translation>El sistema de coordenadas del mapa no llega hasta allí.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Skyline drawn. Press Snap to fit the horizon to it.</source>
        <translation>Línea del horizonte dibujada. Pulse Ajustar para ajustar el horizonte a ella.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Masked. Press Snap to fit the horizon without it.</source>
        <translation>Enmascarado. Pulse Ajustar para ajustar el horizonte sin esa parte.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>This needs a heading and an elevation model.</source>
        <translation>Esto necesita un rumbo y un modelo de elevaciones.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Drawn into the layer {layer}. Save its edits to keep it.</source>
        <translation>Dibujado en la capa {layer}. Guarde sus ediciones para conservarlo.</translation>
    </message>
    <message>
        <location filename="../panel/figures.py"/>
        <source>Folder of landmarks, skylines and masks</source>
        <translation>Carpeta de puntos de referencia, líneas del horizonte y máscaras</translation>
    </message>
    <message>
        <location filename="../panel/layers.py"/>
        <source>The layer has no photographs.</source>
        <translation>La capa no contiene fotografías.</translation>
    </message>
    <message>
        <location filename="../panel/layers.py"/>
        <source>The layer was removed. Choose another.</source>
        <translation>La capa se ha eliminado. Elija otra.</translation>
    </message>
    <message>
        <location filename="../panel/model/aids.py"/>
        <source>it is not JSON. Mend it, or delete it.</source>
        <translation>no es JSON válido. Repárelo o elimínelo.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>This photograph has no answer {number}.</source>
        <translation>Esta fotografía no tiene respuesta {number}.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Nothing to fit yet: the picture or the elevation model is missing.</source>
        <translation>Aún no hay nada que ajustar: falta la imagen o el modelo de elevaciones.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Fitting ...</source>
        <translation>Ajustando ...</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Fitted: heading {heading}°. Press Keep to write it to the layer.</source>
        <translation>Ajustado: rumbo {heading}°. Pulse Conservar para escribirlo en la capa.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Nothing to keep yet: the photograph has no heading.</source>
        <translation>Aún no hay nada que conservar: la fotografía no tiene rumbo.</translation>
    </message>
    <message>
        <location filename="../panel/model/correcting.py"/>
        <source>Kept in the layer's edit buffer. Save the layer's edits to make it permanent.</source>
        <translation>Conservado en el búfer de edición de la capa. Guarde las ediciones de la capa para hacerlo permanente.</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>horizon moved</source>
        <translation>horizonte movido</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>snapped to the skyline</source>
        <translation>ajustado a la línea del horizonte</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>another answer chosen</source>
        <translation>otra respuesta elegida</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>placed by landmarks</source>
        <translation>situada mediante puntos de referencia</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>landmarks given</source>
        <translation>puntos de referencia indicados</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>skyline drawn</source>
        <translation>línea del horizonte dibujada</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>parts of the picture left out</source>
        <translation>partes de la imagen excluidas</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>confirmed by hand: the answer was right</source>
        <translation>confirmado a mano: la respuesta era correcta</translation>
    </message>
    <message>
        <location filename="../panel/model/draft.py"/>
        <source>corrected by hand: {how}</source>
        <translation>corregido a mano: {how}</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Part of the figure shows the sky or lies beyond the elevation model, so it cannot be measured.</source>
        <translation>Parte de la figura muestra el cielo o queda fuera del modelo de elevaciones, por lo que no se puede medir.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Area on the map {area}, outline {length}.</source>
        <translation>Área en el mapa {area}, contorno {length}.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Distance on the map {length}, height difference {rise} m.</source>
        <translation>Distancia en el mapa {length}, desnivel {rise} m.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Points from photos</source>
        <translation>Puntos de las fotos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Lines from photos</source>
        <translation>Líneas de las fotos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Areas from photos</source>
        <translation>Áreas de las fotos</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>This shows no ground that the elevation model knows, so nothing was drawn.</source>
        <translation>Aquí no se ve terreno que el modelo de elevaciones conozca, así que no se dibujó nada.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>The layer {layer} cannot be edited.</source>
        <translation>La capa {layer} no se puede editar.</translation>
    </message>
    <message>
        <location filename="../panel/model/drawing.py"/>
        <source>Draw in a photo</source>
        <translation>Dibujar en una foto</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Verdict of the review</source>
        <translation>Veredicto de la revisión</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The field {field} does not take the value. Check the layer's fields.</source>
        <translation>El campo {field} no admite el valor. Compruebe los campos de la capa.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The layer {layer} is read-only. Export it as a GeoPackage, and correct the photographs there.</source>
        <translation>La capa {layer} es de solo lectura. Expórtela como GeoPackage y corrija allí las fotografías.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>The layer takes no new fields ({fields}). Export it as a GeoPackage first.</source>
        <translation>La capa no admite campos nuevos ({fields}). Expórtela primero como GeoPackage.</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Correct {photo}</source>
        <translation>Corregir {photo}</translation>
    </message>
    <message>
        <location filename="../panel/model/edits.py"/>
        <source>Review {photo}</source>
        <translation>Revisar {photo}</translation>
    </message>
    <message>
        <location filename="../panel/model/faults.py"/>
        <source>An unexpected error occurred. Please report it and attach the log.</source>
        <translation>Se ha producido un error inesperado. Comuníquelo y adjunte el registro.</translation>
    </message>
    <message>
        <location filename="../panel/model/photo_layer.py"/>
        <source>The layer has no field with the photographs' paths. Choose the result of Orient photos.</source>
        <translation>La capa no tiene ningún campo con las rutas de las fotografías. Elija el resultado de Orientar fotos.</translation>
    </message>
    <message>
        <location filename="../panel/model/session.py"/>
        <source>The photograph is no longer in the layer.</source>
        <translation>La fotografía ya no está en la capa.</translation>
    </message>
    <message>
        <location filename="../panel/model/session.py"/>
        <source>Choose an elevation model to see the horizon.</source>
        <translation>Elija un modelo de elevaciones para ver el horizonte.</translation>
    </message>
    <message>
        <location filename="../panel/model/solving.py"/>
        <source>The skyline contradicts the landmarks, so the horizon stays where they put it. Check the landmarks, or mask what hides the skyline.</source>
        <translation>La línea del horizonte contradice los puntos de referencia, así que el horizonte queda donde ellos lo ponen. Compruebe los puntos de referencia o enmascare lo que oculta la línea del horizonte.</translation>
    </message>
    <message>
        <location filename="../panel/model/solving.py"/>
        <source>The skyline does not decide more exactly here, so the horizon stays where you put it. Set a landmark, draw the skyline, or mask what hides it.</source>
        <translation>La línea del horizonte no lo decide aquí con más exactitud, así que el horizonte queda donde usted lo puso. Ponga un punto de referencia, dibuje la línea del horizonte o enmascare lo que la oculta.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The algorithm Directed viewshed is not there. Switch Processing on in the plugin manager.</source>
        <translation>Falta el algoritmo Cuenca visual dirigida. Active Processing en el administrador de complementos.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The viewshed could not be computed. The log of Processing says why.</source>
        <translation>No se pudo calcular la cuenca visual. El registro de Processing indica por qué.</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>Viewshed of {photo}</source>
        <translation>Cuenca visual de {photo}</translation>
    </message>
    <message>
        <location filename="../panel/model/viewsheds.py"/>
        <source>The viewshed of {photo} is in the project.</source>
        <translation>La cuenca visual de {photo} está en el proyecto.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the previous photograph.</source>
        <translation>Muestra la fotografía anterior.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the next photograph.</source>
        <translation>Muestra la fotografía siguiente.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Next doubtful</source>
        <translation>Siguiente dudosa</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Show the next photograph whose status is ambiguous, rejected or failed.</source>
        <translation>Muestra la siguiente fotografía cuyo estado es ambiguous, rejected o failed.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Look</source>
        <translation>Mirar</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Drag to pan, wheel to zoom, double click to see the whole picture.</source>
        <translation>Arrastre para desplazar, rueda para ampliar, doble clic para ver la imagen entera.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Correct</source>
        <translation>Corregir</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Drag the horizon. The right button or Shift turns it, the wheel changes the field of view. Arrow keys, comma, full stop, plus and minus do the same.</source>
        <translation>Arrastre el horizonte. El botón derecho o Mayús lo gira, la rueda cambia el ángulo de visión. Las flechas, la coma, el punto, más y menos hacen lo mismo.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Landmark</source>
        <translation>Punto de referencia</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a point in the picture, then the same point on the map.</source>
        <translation>Haga clic en un punto de la imagen y luego en el mismo punto del mapa.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the sun in the picture. Its direction follows from the time and the place of the photograph.</source>
        <translation>Haga clic en el Sol en la imagen. Su dirección se deduce de la hora y el lugar de la fotografía.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Moon</source>
        <translation>Luna</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the moon in the picture. Its direction follows from the time and the place of the photograph.</source>
        <translation>Haga clic en la Luna en la imagen. Su dirección se deduce de la hora y el lugar de la fotografía.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw skyline</source>
        <translation>Dibujar la línea del horizonte</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw the whole skyline by hand; the extracted one is ignored.</source>
        <translation>Dibuje a mano toda la línea del horizonte; la extraída no se usa.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Repair skyline</source>
        <translation>Reparar la línea del horizonte</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw over a wrong stretch of the extracted skyline.</source>
        <translation>Dibuje sobre un tramo erróneo de la línea extraída.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Mask</source>
        <translation>Enmascarar</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Brush over what hides the skyline: flags, clouds, people, trees.</source>
        <translation>Pinte sobre lo que oculta la línea del horizonte: banderas, nubes, personas, árboles.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Measure distance</source>
        <translation>Medir distancia</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click points in the picture: distance and height difference on the ground.</source>
        <translation>Haga clic en puntos de la imagen: distancia y desnivel en el terreno.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Measure area</source>
        <translation>Medir área</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click the corners of an area in the picture.</source>
        <translation>Haga clic en las esquinas de un área de la imagen.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw point</source>
        <translation>Dibujar punto</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a point in the picture; it goes to the active layer if that is edited, else to a new one.</source>
        <translation>Haga clic en un punto de la imagen; va a la capa activa si se está editando, y si no a una nueva.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw line</source>
        <translation>Dibujar línea</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a line in the picture. A double click, Enter or the right button ends it.</source>
        <translation>Marque una línea en la imagen. Un doble clic, Intro o el botón derecho la termina.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Draw area</source>
        <translation>Dibujar área</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click an area in the picture. A double click, Enter or the right button ends it.</source>
        <translation>Marque un área en la imagen. Un doble clic, Intro o el botón derecho la termina.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Face a place</source>
        <translation>Orientar hacia un lugar</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Click a place on the map: the camera turns to it.</source>
        <translation>Haga clic en un lugar del mapa: la cámara gira hacia él.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Snap</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Fit the horizon to the picture from where it is.</source>
        <translation>Ajusta el horizonte a la imagen desde donde está.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Use alternative 2</source>
        <translation>Usar la alternativa 2</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the second-best heading of the table, and fit from there.</source>
        <translation>Toma el segundo mejor rumbo de la tabla y ajusta desde ahí.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Use alternative 3</source>
        <translation>Usar la alternativa 3</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the third-best heading of the table, and fit from there.</source>
        <translation>Toma el tercer mejor rumbo de la tabla y ajusta desde ahí.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Take the last change back.</source>
        <translation>Deshace el último cambio.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Make the change again.</source>
        <translation>Vuelve a hacer el cambio.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Write the correction to the layer's edit buffer, with the status confirmed.</source>
        <translation>Escribe la corrección en el búfer de edición de la capa, con el estado confirmed.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Compute the ground that this photograph shows, and add it as a layer.</source>
        <translation>Calcula el terreno que muestra esta fotografía y lo añade como capa.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Review</source>
        <translation>Revisión</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Judge one photograph after the other with single keys.</source>
        <translation>Juzgue una fotografía tras otra con una sola tecla.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Accept</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>The answer is right.</source>
        <translation>La respuesta es correcta.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Reject</source>
        <translation>Rechazar</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>The answer is wrong.</source>
        <translation>La respuesta es errónea.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Doubtful</source>
        <translation>Dudosa</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>It cannot be told.</source>
        <translation>No se puede decidir.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Skip</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Leave it for later.</source>
        <translation>Dejarla para más tarde.</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Horizon of the elevation model</source>
        <translation>Horizonte del modelo de elevaciones</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Crests below the horizon</source>
        <translation>Crestas bajo el horizonte</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Skyline in the picture</source>
        <translation>Línea del horizonte en la imagen</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <location filename="../core/report/card.py"/>
        <source>Alternatives</source>
        <translation>Alternativas</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Azimuth and elevation angle</source>
        <translation>Acimut y ángulo de elevación</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Map layers</source>
        <translation>Capas del mapa</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Page up</source>
        <translation>Re Pág</translation>
    </message>
    <message>
        <location filename="../panel/view/actions.py"/>
        <source>Page down</source>
        <translation>Av Pág</translation>
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
        <translation>Mayús</translation>
    </message>
    <message>
        <location filename="../panel/view/canvas.py"/>
        <source>Photograph</source>
        <translation>Fotografía</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Layer of oriented photo points.</source>
        <translation>Capa de puntos de fotos orientadas.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Elevation model</source>
        <translation>Modelo de elevaciones</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Choose what is drawn over the picture.</source>
        <translation>Elija qué se dibuja sobre la imagen.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Remove the landmarks</source>
        <translation>Quitar los puntos de referencia</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Remove what was drawn and masked</source>
        <translation>Quitar lo dibujado y enmascarado</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Folder of landmarks, skylines and masks ...</source>
        <translation>Carpeta de puntos de referencia, líneas del horizonte y máscaras ...</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Show the whole picture</source>
        <translation>Mostrar la imagen entera</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Further commands for this photograph.</source>
        <translation>Más órdenes para esta fotografía.</translation>
    </message>
    <message>
        <location filename="../panel/view/dock.py"/>
        <source>Reviewed photographs</source>
        <translation>Fotografías revisadas</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>In the picture, {distance} away.</source>
        <translation>En la imagen, a {distance}.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Hidden by terrain at {distance}.</source>
        <translation>Oculto por el terreno a {distance}.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>The elevation model does not know this place.</source>
        <translation>El modelo de elevaciones no conoce este lugar.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, straight ahead.</source>
        <translation>Fuera de la imagen, en línea recta.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, {angle}° to the right of its middle.</source>
        <translation>Fuera de la imagen, {angle}° a la derecha de su centro.</translation>
    </message>
    <message>
        <location filename="../panel/view/spots.py"/>
        <source>Outside the picture, {angle}° to the left of its middle.</source>
        <translation>Fuera de la imagen, {angle}° a la izquierda de su centro.</translation>
    </message>
    <message>
        <location filename="../panel/view/strip.py"/>
        <source>Photographs of the layer</source>
        <translation>Fotografías de la capa</translation>
    </message>
    <message>
        <location filename="../panel/view/strip.py"/>
        <source>Click a photograph to show it.</source>
        <translation>Haga clic en una fotografía para mostrarla.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>No photograph. Click a point on the map with the selection tool, or a thumbnail below.</source>
        <translation>Ninguna fotografía. Haga clic en un punto del mapa con la herramienta de selección, o en una miniatura de abajo.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>heading {heading}°, pitch {pitch}°, roll {roll}°, field of view {hfov}°</source>
        <translation>rumbo {heading}°, cabeceo {pitch}°, alabeo {roll}°, ángulo de visión {hfov}°</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>no heading yet: press Snap, drag the horizon, or set a landmark</source>
        <translation>sin rumbo todavía: pulse Ajustar, arrastre el horizonte o ponga un punto de referencia</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>the field of view is assumed</source>
        <translation>el ángulo de visión es supuesto</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>changed, not kept</source>
        <translation>cambiada, sin conservar</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>azimuth {azimuth}°, elevation angle {angle}°</source>
        <translation>acimut {azimuth}°, ángulo de elevación {angle}°</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>{elevation} m high, {distance} km away (90 %: {near} to {far} km), {direction}</source>
        <translation>{elevation} m de altitud, a {distance} km (90 %: de {near} a {far} km), {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>Sky, {direction}</source>
        <translation>Cielo, {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>Beyond the elevation model or in a hole of it, {direction}</source>
        <translation>Fuera del modelo de elevaciones o en un hueco de él, {direction}</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>The sun stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep.</source>
        <translation>El Sol estaba en el acimut {azimuth}°, ángulo de elevación {angle}°. Pulse Ajustar o pulse Conservar.</translation>
    </message>
    <message>
        <location filename="../panel/words.py"/>
        <source>The moon stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep.</source>
        <translation>La Luna estaba en el acimut {azimuth}°, ángulo de elevación {angle}°. Pulse Ajustar o pulse Conservar.</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>GPS altitude (m)</source>
        <translation>Altitud GPS (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading (°)</source>
        <translation>Rumbo registrado (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Rotation by EXIF (°)</source>
        <translation>Rotación según EXIF (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Longitude (°)</source>
        <translation>Longitud (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Latitude (°)</source>
        <translation>Latitud (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Taken at (camera's local time)</source>
        <translation>Momento de la toma (hora local de la cámara)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>35 mm equivalent focal length (mm)</source>
        <translation>Distancia focal equivalente en 35 mm (mm)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Width of the upright picture (px)</source>
        <translation>Anchura de la imagen enderezada (px)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Height of the upright picture (px)</source>
        <translation>Altura de la imagen enderezada (px)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading counts from (T true, M magnetic north)</source>
        <translation>Referencia del rumbo registrado (T norte geográfico, M norte magnético)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>GPS horizontal error (m)</source>
        <translation>Error horizontal del GPS (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Correlation of skylines</source>
        <translation>Correlación de las líneas del horizonte</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Correlation of the second-best heading</source>
        <translation>Correlación del segundo mejor rumbo</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Second-best heading (°)</source>
        <translation>Segundo mejor rumbo (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Third-best heading (°)</source>
        <translation>Tercer mejor rumbo (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Sharpness of the correlation peak</source>
        <translation>Nitidez del pico de correlación</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Heading, lower end of the 90 % interval (°)</source>
        <translation>Rumbo, extremo inferior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Heading, upper end of the 90 % interval (°)</source>
        <translation>Rumbo, extremo superior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch, lower end of the 90 % interval (°)</source>
        <translation>Cabeceo, extremo inferior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Pitch, upper end of the 90 % interval (°)</source>
        <translation>Cabeceo, extremo superior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Roll, lower end of the 90 % interval (°)</source>
        <translation>Alabeo, extremo inferior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Roll, upper end of the 90 % interval (°)</source>
        <translation>Alabeo, extremo superior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view, lower end of the 90 % interval (°)</source>
        <translation>Ángulo de visión horizontal, extremo inferior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Horizontal field of view, upper end of the 90 % interval (°)</source>
        <translation>Ángulo de visión horizontal, extremo superior del intervalo del 90 % (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded heading (° from true north)</source>
        <translation>Rumbo registrado (° desde el norte geográfico)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Recorded minus found heading (°)</source>
        <translation>Rumbo registrado menos rumbo hallado (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Grid convergence of the DEM (°)</source>
        <translation>Convergencia de meridianos del MDE (°)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Distance of the horizon at the heading (m)</source>
        <translation>Distancia del horizonte en el rumbo (m)</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Camera above the DEM (m), for Visibility Analysis</source>
        <translation>Cámara sobre el MDE (m), para Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Search range (m), for Visibility Analysis</source>
        <translation>Alcance de búsqueda (m), para Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Left edge of view (° from grid north), for Visibility Analysis</source>
        <translation>Borde izquierdo de la vista (° desde el norte de la cuadrícula), para Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/attributes.py"/>
        <source>Right edge of view (° from grid north), for Visibility Analysis</source>
        <translation>Borde derecho de la vista (° desde el norte de la cuadrícula), para Visibility Analysis</translation>
    </message>
    <message>
        <location filename="../core/base/doubt.py"/>
        <source>The position is uncertain by {metres} m, which leaves the heading uncertain by more than 3 degrees. Correct the position.</source>
        <translation>La posición tiene una incertidumbre de {metres} m, por lo que el rumbo es incierto en más de 3 grados. Corrija la posición.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The photo {path} cannot be read: {reason}</source>
        <translation>No se puede leer la foto {path}: {reason}</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>{reason} Use a photo that shows a mountain skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>{reason} Use una foto que muestre una línea del horizonte de montañas, o aporte una máscara del cielo o una línea dibujada.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The position {latitude}, {longitude} (latitude, longitude) lies outside the DEM. Use a DEM that covers it, or correct the photo's coordinates.</source>
        <translation>La posición {latitude}, {longitude} (latitud, longitud) está fuera del MDE. Use un MDE que la cubra o corrija las coordenadas de la foto.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The DEM has no elevation (nodata) at {latitude}, {longitude} (latitude, longitude). Fill the void, use another DEM, or give the eye's elevation in HEIGHT_FIELD.</source>
        <translation>El MDE no tiene altitud (sin datos) en {latitude}, {longitude} (latitud, longitud). Rellene el hueco, use otro MDE o dé la altitud de la cámara en HEIGHT_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The file {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>No se puede escribir el archivo {path}: {reason}. Elija otra carpeta o libere espacio.</translation>
    </message>
    <message>
        <location filename="../core/base/errors.py"/>
        <source>The image features {path} cannot be read: {reason}</source>
        <translation>No se pueden leer los objetos de la imagen {path}: {reason}</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The given elevation of the camera lies {metres} m below the DEM's surface, so the answer is not accepted. Check HEIGHT_FIELD, and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>La elevación indicada de la cámara queda {metres} m por debajo de la superficie del MDE, por lo que la respuesta no se acepta. Compruebe HEIGHT_FIELD y la unidad de las alturas del MDE (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface, more than GPS and DEM allow, so the answer is not accepted. Check the photo's position, and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>La altitud registrada queda {metres} m por debajo de la superficie del MDE, más de lo que permiten el GPS y el MDE, por lo que la respuesta no se acepta. Compruebe la posición de la foto y la unidad de las alturas del MDE (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface, more than GPS and DEM allow, so the answer is not accepted. Check the photo's position and the DEM; for a drone, set USE_ALTITUDE.</source>
        <translation>La altitud registrada queda {metres} m por encima de la superficie del MDE, más de lo que permiten el GPS y el MDE, por lo que la respuesta no se acepta. Compruebe la posición de la foto y el MDE; para un dron, active USE_ALTITUDE.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The skyline fits best from {metres} m above the DEM's surface, which was used.</source>
        <translation>La línea del horizonte encaja mejor desde {metres} m por encima de la superficie del MDE; se ha usado esa altura.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The skyline fits best from {metres} m below the DEM's surface, which was used.</source>
        <translation>La línea del horizonte encaja mejor desde {metres} m por debajo de la superficie del MDE; se ha usado esa altura.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude refers to the ellipsoid, not to sea level; the DEM was used.</source>
        <translation>La altitud registrada se refiere al elipsoide y no al nivel del mar; se usó el MDE.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface and was used.</source>
        <translation>La altitud registrada queda {metres} m por encima de la superficie del MDE y se usó.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface and was used.</source>
        <translation>La altitud registrada queda {metres} m por debajo de la superficie del MDE y se usó.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m above the DEM's surface; the DEM was used.</source>
        <translation>La altitud registrada queda {metres} m por encima de la superficie del MDE; se usó el MDE.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The recorded altitude lies {metres} m below the DEM's surface; the DEM was used.</source>
        <translation>La altitud registrada queda {metres} m por debajo de la superficie del MDE; se usó el MDE.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if its heights were in {unit}. Set the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>El MDE difiere en {metres} m (mediana de {count} fotos) de las altitudes registradas, como si sus alturas estuvieran en {unit}. Indique la unidad de las alturas del MDE (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, as if these were in feet. The program that wrote them is wrong; the DEM is used for the camera's elevation.</source>
        <translation>El MDE difiere en {metres} m (mediana de {count} fotos) de las altitudes registradas, como si estas estuvieran en pies. El programa que las escribió se equivoca; para la elevación de la cámara se usa el MDE.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes, nearly the same everywhere, as if one of them counted from the ellipsoid or another vertical datum. Use a DEM with heights above sea level.</source>
        <translation>El MDE difiere en {metres} m (mediana de {count} fotos) de las altitudes registradas, casi lo mismo en todas partes, como si uno de los dos contara desde el elipsoide u otro dátum vertical. Use un MDE con alturas sobre el nivel del mar.</translation>
    </message>
    <message>
        <location filename="../core/base/heights.py"/>
        <source>The DEM differs by {metres} m (median of {count} photos) from the recorded altitudes. Check that the DEM holds heights, their unit (DEM_UNIT) and vertical datum, and the positions of the photos.</source>
        <translation>El MDE difiere en {metres} m (mediana de {count} fotos) de las altitudes registradas. Compruebe que el MDE contenga alturas, su unidad (DEM_UNIT) y su dátum vertical, y las posiciones de las fotos.</translation>
    </message>
    <message>
        <location filename="../core/base/landmark_hint.py"/>
        <source>A landmark is the sun or the moon, but the photo does not record its time with a time zone. Write the tags DateTimeOriginal and OffsetTimeOriginal, or leave this landmark out.</source>
        <translation>Un punto de referencia es el Sol o la Luna, pero la foto no registra su hora con una zona horaria. Escriba las etiquetas DateTimeOriginal y OffsetTimeOriginal o prescinda de este punto de referencia.</translation>
    </message>
    <message>
        <location filename="../core/base/landmark_hint.py"/>
        <source>A landmark is the sun or the moon, which was below the horizon at {time}. Check the landmark and the clock of the camera.</source>
        <translation>Un punto de referencia es el Sol o la Luna, que estaba bajo el horizonte a las {time}. Compruebe el punto de referencia y el reloj de la cámara.</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>{feature} needs the Python package {package}. {hint}</source>
        <translation>{feature} necesita el paquete de Python {package}. {hint}</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>Run: {command} (or install your distribution's package)</source>
        <translation>Ejecute: {command} (o instale el paquete de su distribución)</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>In the OSGeo4W Shell run: {command}</source>
        <translation>Ejecute en la OSGeo4W Shell: {command}</translation>
    </message>
    <message>
        <location filename="../core/base/optional.py"/>
        <source>Run: {command}</source>
        <translation>Ejecute: {command}</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The photo has no GPS position. Supply it as a point in a photo point layer.</source>
        <translation>La foto no tiene posición GPS. Indíquela con un punto en una capa de puntos de fotos.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The GPS position is uncertain by {km} km, too much for a horizon, so the right one is needed. Supply it as a point in a photo point layer.</source>
        <translation>La posición GPS tiene una incertidumbre de {km} km, demasiado para un horizonte, por lo que se necesita la correcta. Indíquela con un punto en una capa de puntos de fotos.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The position is uncertain by {km} km (h_acc), so the result may hold for another place than the camera's. Move the point to where the camera was, and clear h_acc.</source>
        <translation>La posición tiene una incertidumbre de {km} km (h_acc), por lo que el resultado puede corresponder a un lugar distinto del de la cámara. Mueva el punto al lugar donde estaba la cámara y vacíe h_acc.</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The eye lies {metres} m below the DEM's surface, so the result is not what a camera sees. Check the camera's elevation (HEIGHT_FIELD), and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>El ojo queda {metres} m por debajo de la superficie del MDE, por lo que el resultado no es lo que ve una cámara. Compruebe la elevación de la cámara (HEIGHT_FIELD) y la unidad de las alturas del MDE (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/place.py"/>
        <source>The eye lies {metres} m above the DEM's surface. Unless the camera flew so high, check its elevation (HEIGHT_FIELD), its height above the ground (EYE_HEIGHT), and the unit of the DEM's heights (DEM_UNIT).</source>
        <translation>El ojo queda {metres} m por encima de la superficie del MDE. Si la cámara no voló tan alto, compruebe su elevación (HEIGHT_FIELD), su altura sobre el suelo (EYE_HEIGHT) y la unidad de las alturas del MDE (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on the picture as it is stored; they were rotated with it.</source>
        <translation>Sus objetos se dibujaron sobre la imagen tal como está guardada; se giraron con ella.</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on a copy of {width} x {height} pixels; they were scaled to the photo.</source>
        <translation>Sus objetos se dibujaron sobre una copia de {width} x {height} píxeles; se escalaron a la foto.</translation>
    </message>
    <message>
        <location filename="../core/base/upright.py"/>
        <source>Its features were drawn on a picture of {width} x {height} pixels, which is no reduced copy of this photo of {photo_width} x {photo_height} pixels. Draw them on the photo itself.</source>
        <translation>Sus objetos se dibujaron sobre una imagen de {width} x {height} píxeles, que no es una copia reducida de esta foto de {photo_width} x {photo_height} píxeles. Dibújelos sobre la propia foto.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>In other photos of this run, the compass of this camera often contradicts the skyline, so its reading counts for less.</source>
        <translation>En otras fotos de este proceso, la brújula de esta cámara contradice a menudo la línea del horizonte, por lo que su indicación cuenta menos.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>The photo is a stitched panorama, which is not the picture of one lens. Use a single photo, or give the horizontal field of view in HFOV_FIELD if the panorama is rectilinear.</source>
        <translation>La foto es un panorama compuesto, que no es la imagen de un solo objetivo. Use una sola foto o, si el panorama es rectilíneo, indique el ángulo de visión horizontal en HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>A lens with k1 = {k1} and k2 = {k2} would fold the picture before its corner. Correct k1 and k2: they are those of OpenCV, for radii in focal lengths.</source>
        <translation>Un objetivo con k1 = {k1} y k2 = {k2} plegaría la imagen antes de su esquina. Corrija k1 y k2: son los de OpenCV, para radios en distancias focales.</translation>
    </message>
    <message>
        <location filename="../core/batch.py"/>
        <source>The drawn skyline reaches beyond the picture of {width} x {height} pixels. Draw it on this picture, not on a reduced or turned copy.</source>
        <translation>La línea del horizonte dibujada sobresale de la imagen de {width} x {height} píxeles. Dibújela sobre esta imagen, no sobre una copia reducida o girada.</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>No place within {radius} m explains the skyline well. Check the field of view and the DEM, or search a larger area with Locate photos.</source>
        <translation>Ningún lugar a menos de {radius} m explica bien la línea del horizonte. Compruebe el ángulo de visión y el MDE, o busque en un área mayor con «Localizar fotos».</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>The skyline fits from the recorded position about as well as from anywhere near it.</source>
        <translation>La línea del horizonte encaja desde la posición registrada más o menos igual que desde cualquier lugar cercano.</translation>
    </message>
    <message>
        <location filename="../core/checking.py"/>
        <source>The skyline fits much better {distance} m away, at azimuth {azimuth} degrees; the heading differs by {turn} degrees there. Check the recorded position, which was not changed.</source>
        <translation>La línea del horizonte encaja mucho mejor a {distance} m, en el acimut {azimuth} grados; el rumbo difiere allí en {turn} grados. Compruebe la posición registrada, que no se ha cambiado.</translation>
    </message>
    <message>
        <location filename="../core/figures/annotate.py"/>
        <source>annotated photograph</source>
        <translation>fotografía rotulada</translation>
    </message>
    <message>
        <location filename="../core/figures/fonts.py"/>
        <source>Text in pictures needs a TrueType font, but none of DejaVu Sans, Arial, Liberation Sans or Helvetica is installed. Install one of them, for example with the package fonts-dejavu-core, or install a newer Pillow.</source>
        <translation>El texto en las imágenes necesita un tipo de letra TrueType, pero no está instalado ninguno de estos: DejaVu Sans, Arial, Liberation Sans o Helvetica. Instale uno de ellos, por ejemplo con el paquete fonts-dejavu-core, o instale una versión más reciente de Pillow.</translation>
    </message>
    <message>
        <location filename="../core/figures/fonts.py"/>
        <location filename="../core/figures/raster.py"/>
        <source>Drawing and writing pictures</source>
        <translation>Dibujar y escribir imágenes</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>view</source>
        <translation>vista</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>heading</source>
        <translation>rumbo</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>viewshed</source>
        <translation>cuenca visual</translation>
    </message>
    <message>
        <location filename="../core/figures/ground.py"/>
        <source>photograph</source>
        <translation>fotografía</translation>
    </message>
    <message>
        <location filename="../core/figures/overlay.py"/>
        <location filename="../core/report/overview.py"/>
        <source>extracted skyline</source>
        <translation>línea del horizonte extraída</translation>
    </message>
    <message>
        <location filename="../core/figures/overlay.py"/>
        <source>DEM horizon at {heading}</source>
        <translation>horizonte del MDE a {heading}</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <location filename="../core/figures/score.py"/>
        <source>The DEM has no horizon here.</source>
        <translation>El MDE no tiene horizonte aquí.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Horizon of the DEM over all azimuths</source>
        <translation>Horizonte del MDE en todos los acimuts</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Image skyline against DEM horizon</source>
        <translation>Línea del horizonte de la imagen frente al horizonte del MDE</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>No column of the picture was compared with the DEM.</source>
        <translation>Ninguna columna de la imagen se comparó con el MDE.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Skyline above DEM [px]</source>
        <translation>Línea sobre el MDE [px]</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Residuals along the columns: {words}.</source>
        <translation>Residuos a lo largo de las columnas: {words}.</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>no column compared</source>
        <translation>ninguna columna comparada</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>median {value}</source>
        <translation>mediana {value}</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>{share} % of the height</source>
        <translation>{share} % de la altura</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>{share} % of columns</source>
        <translation>{share} % de las columnas</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Elevation angle</source>
        <translation>Ángulo de elevación</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>cut by the DEM's edge</source>
        <translation>cortado por el borde del MDE</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>void</source>
        <translation>vacío</translation>
    </message>
    <message>
        <location filename="../core/figures/profile.py"/>
        <source>The horizon is highest at azimuth {azimuth}: its elevation angle there is {angle} degrees and its distance {distance}. The median elevation angle is {median} degrees. In {share} % of the directions the DEM ends before higher terrain can be ruled out.</source>
        <translation>El horizonte alcanza su máximo en el acimut {azimuth}: allí su ángulo de elevación es de {angle} grados y su distancia, de {distance}. La mediana del ángulo de elevación es de {median} grados. En el {share} % de las direcciones el MDE termina antes de que se pueda descartar terreno más alto.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Score over all headings</source>
        <translation>Puntuación en todos los rumbos</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>No heading was scored.</source>
        <translation>No se evaluó ningún rumbo.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>compass</source>
        <translation>brújula</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>{score} over all headings</source>
        <translation>{score} en todos los rumbos</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Score by direction, north up</source>
        <translation>Puntuación por dirección, norte arriba</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The probability is highest at azimuth {heading}: {share} %.</source>
        <translation>La probabilidad es máxima en el acimut {heading}: {share} %.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Probability of a unique answer by direction, north up</source>
        <translation>Probabilidad de una respuesta única por dirección, norte arriba</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>No heading was found.</source>
        <translation>No se encontró ningún rumbo.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The best heading is {heading} from true north.</source>
        <translation>El mejor rumbo es {heading} desde el norte geográfico.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>Alternatives are at {headings}.</source>
        <translation>Las alternativas están a {headings}.</translation>
    </message>
    <message>
        <location filename="../core/figures/score.py"/>
        <source>The compass recorded {heading}.</source>
        <translation>La brújula registró {heading}.</translation>
    </message>
    <message>
        <location filename="../core/figures/stations.py"/>
        <source>{count} photographs within {extent} kilometres.</source>
        <translation>{count} fotografías en {extent} kilómetros.</translation>
    </message>
    <message>
        <location filename="../core/figures/stations.py"/>
        <location filename="../core/report/collection.py"/>
        <location filename="../core/report/report.py"/>
        <source>Camera positions and headings</source>
        <translation>Posiciones y rumbos de la cámara</translation>
    </message>
    <message>
        <location filename="../core/figures/text.py"/>
        <source>N NNE NE ENE E ESE SE SSE S SSW SW WSW W WNW NW NNW</source>
        <translation>N NNE NE ENE E ESE SE SSE S SSO SO OSO O ONO NO NNO</translation>
    </message>
    <message>
        <location filename="../core/io/crs.py"/>
        <source>The coordinate reference system {crs} is not recognised. Assign a valid one.</source>
        <translation>No se reconoce el sistema de referencia de coordenadas {crs}. Asigne uno válido.</translation>
    </message>
    <message>
        <location filename="../core/io/crs.py"/>
        <source>No transformation from {source} to {target} is available. Use a DEM in a common coordinate system.</source>
        <translation>No hay ninguna transformación disponible de {source} a {target}. Use un MDE en un sistema de coordenadas habitual.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} is a picture with a colour palette, not a raster of heights. Choose the elevation raster itself.</source>
        <translation>El MDE {path} es una imagen con paleta de colores, no un ráster de alturas. Elija el propio ráster de elevación.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} has only 8 bits per cell, like a hillshade or another picture of the terrain. Choose the elevation raster itself; if these are heights, set their unit (DEM_UNIT).</source>
        <translation>El MDE {path} tiene solo 8 bits por celda, como un sombreado u otra imagen del terreno. Elija el propio ráster de elevación; si son alturas, indique su unidad (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} holds heights encoded as colours (terrain-RGB, {name}). Decode them first with the raster calculator: {formula}, where R, G and B are the bands.</source>
        <translation>El MDE {path} contiene alturas codificadas como colores (terrain-RGB, {name}). Descodifíquelas primero con la calculadora ráster: {formula}, donde R, G y B son las bandas.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} is a colour picture (red, green, blue), not a raster of heights. Choose the elevation raster itself.</source>
        <translation>El MDE {path} es una imagen en color (rojo, verde, azul), no un ráster de alturas. Elija el propio ráster de elevación.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>Band {band} of the DEM {path} has no valid cell. Choose another DEM.</source>
        <translation>La banda {band} del MDE {path} no tiene ninguna celda válida. Elija otro MDE.</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The DEM {path} has values up to {highest}, which are no heights in metres: perhaps they are decimetres or centimetres. Set their unit (DEM_UNIT).</source>
        <translation>El MDE {path} tiene valores de hasta {highest}, que no son alturas en metros: quizá sean decímetros o centímetros. Indique su unidad (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/dem_inspection.py"/>
        <source>The values of the DEM {path} lie between {low} and {high} and change from cell to cell like those of a hillshade, slope or aspect map, not like heights. Choose the elevation raster itself; if these are heights, set their unit (DEM_UNIT).</source>
        <translation>Los valores del MDE {path} están entre {low} y {high} y cambian de celda a celda como los de un sombreado o un mapa de pendientes u orientaciones, no como alturas. Elija el propio ráster de elevación; si son alturas, indique su unidad (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is larger than 200 MB. Split it by photograph.</source>
        <translation>ocupa más de 200 MB. Divídalo por fotografías.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not UTF-8 text. Export it as JSON or CSV.</source>
        <translation>no es texto en UTF-8. Expórtelo como JSON o CSV.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <location filename="../core/io/formats.py"/>
        <source>it cannot be opened ({reason}). Check the path and the permissions.</source>
        <translation>no se puede abrir ({reason}). Compruebe la ruta y los permisos.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not valid JSON. Export it again.</source>
        <translation>no es JSON válido. Expórtelo de nuevo.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it is not in the format of LabelMe, COCO, VIA or GeoJSON. Export it in one of these formats, or as CSV with the columns photo, x and y.</source>
        <translation>no tiene el formato de LabelMe, COCO, VIA ni GeoJSON. Expórtelo en uno de estos formatos, o como CSV con las columnas photo, x e y.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>an entry is incomplete ({reason}). Export the file again.</source>
        <translation>una entrada está incompleta ({reason}). Exporte de nuevo el archivo.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>it has no columns x and y (pixels). Name its columns photo, x and y.</source>
        <translation>no tiene columnas x e y (píxeles). Llame a las columnas photo, x e y.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>line {number} has no numbers for x and y. Correct that line.</source>
        <translation>la línea {number} no tiene números para x e y. Corrija esa línea.</translation>
    </message>
    <message>
        <location filename="../core/io/features.py"/>
        <source>line {number} is incomplete ({reason}). Correct that line.</source>
        <translation>la línea {number} está incompleta ({reason}). Corrija esa línea.</translation>
    </message>
    <message>
        <location filename="../core/io/folder.py"/>
        <source>The folder {folder} cannot be listed: {reason}. Check the path.</source>
        <translation>No se puede listar la carpeta {folder}: {reason}. Compruebe la ruta.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>the file is empty. Copy it again from its source.</source>
        <translation>el archivo está vacío. Cópielo de nuevo desde su origen.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it ends too early or its directory is damaged. Copy it again from its source.</source>
        <translation>termina antes de tiempo o su directorio está dañado. Cópielo de nuevo desde su origen.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>its content is not a JPEG, HEIC, PNG, TIFF or WebP picture. Export it as JPEG.</source>
        <translation>su contenido no es una imagen JPEG, HEIC, PNG, TIFF ni WebP. Expórtela como JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it has no pixels. Copy it again from its source.</source>
        <translation>no tiene píxeles. Cópielo de nuevo desde su origen.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>its {width} x {height} pixels are more than {limit} megapixels. Reduce its size first.</source>
        <translation>sus {width} x {height} píxeles son más de {limit} megapíxeles. Reduzca antes la imagen.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>it is a folder or a device, not a file. Check the path.</source>
        <translation>es una carpeta o un dispositivo, no un archivo. Compruebe la ruta.</translation>
    </message>
    <message>
        <location filename="../core/io/formats.py"/>
        <source>there is no such file. Check the path.</source>
        <translation>no existe tal archivo. Compruebe la ruta.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} has {count} band(s), but no band {band}. Choose another.</source>
        <translation>El MDE {path} tiene {count} banda(s), pero ninguna banda {band}. Elija otra banda.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>Band {band} of {path} contains complex numbers. Choose an elevation raster.</source>
        <translation>La banda {band} de {path} contiene números complejos. Elija un ráster de altitudes.</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} has no geographic or projected coordinate reference system. Assign the right one (gdal_edit -a_srs).</source>
        <translation>El MDE {path} no tiene un sistema de referencia de coordenadas geográfico o proyectado. Asigne el correcto (gdal_edit -a_srs).</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The coordinate reference system of the DEM {path} cannot be used. {reason}</source>
        <translation>No se puede usar el sistema de referencia de coordenadas del MDE {path}. {reason}</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} is not georeferenced. Warp it to a CRS first (gdalwarp).</source>
        <translation>El MDE {path} no está georreferenciado. Llévelo primero a un SRC (gdalwarp).</translation>
    </message>
    <message>
        <location filename="../core/io/georeference.py"/>
        <source>The DEM {path} is rotated relative to its CRS. Warp it to a north-up grid first (gdalwarp).</source>
        <translation>El MDE {path} está girado respecto de su SRC. Transfórmelo antes a una malla orientada al norte (gdalwarp).</translation>
    </message>
    <message>
        <location filename="../core/io/gpx.py"/>
        <source>The track {path} has no points. Choose a GPX file with a recorded track.</source>
        <translation>El track {path} no tiene puntos. Elija un archivo GPX con un track grabado.</translation>
    </message>
    <message>
        <location filename="../core/io/height_unit.py"/>
        <source>The values of the DEM are in {unit}, which is not a unit of height that is known here. Choose an elevation raster, or set the unit of its heights (DEM_UNIT).</source>
        <translation>Los valores del MDE están en {unit}, que no es una unidad de altura conocida aquí. Elija un ráster de elevación o indique la unidad de sus alturas (DEM_UNIT).</translation>
    </message>
    <message>
        <location filename="../core/io/height_unit.py"/>
        <source>The unit of heights {unit} is not known. Give metres, feet, us-ft, dm, cm, km or a number of metres.</source>
        <translation>La unidad de alturas {unit} no se conoce. Indique metres, feet, us-ft, dm, cm, km o un número de metros.</translation>
    </message>
    <message>
        <location filename="../core/io/label_tools.py"/>
        <source>Shapes without an outline that can be read were left out: {kinds}.</source>
        <translation>Se omitieron las formas sin un contorno legible: {kinds}.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The 35 mm equivalent was derived from the focal length and the focal plane resolution.</source>
        <translation>El equivalente en 35 mm se ha deducido de la distancia focal y la resolución del plano focal.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The recorded 35 mm equivalent of {recorded} mm contradicts the recorded focal length and sensor, from which {derived} mm follows. If you know the horizontal field of view, give it in HFOV_FIELD.</source>
        <translation>El equivalente en 35 mm registrado de {recorded} mm contradice la distancia focal y el sensor registrados, de los que resultan {derived} mm. Si conoce el ángulo de visión horizontal, indíquelo en HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The picture is cropped: a 35 mm equivalent of {used} mm was used instead of {recorded} mm. If you know the horizontal field of view, give it in HFOV_FIELD.</source>
        <translation>La imagen está recortada: se usó un equivalente en 35 mm de {used} mm en lugar de {recorded} mm. Si conoce el ángulo de visión horizontal, indíquelo en HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>No lens has the recorded 35 mm equivalent of {recorded} mm; it was ignored.</source>
        <translation>Ningún objetivo tiene el equivalente en 35 mm registrado de {recorded} mm; se ha descartado.</translation>
    </message>
    <message>
        <location filename="../core/io/lens_tags.py"/>
        <source>The recorded 35 mm equivalent leaves out the digital zoom: {used} mm was used instead of {recorded} mm.</source>
        <translation>El equivalente en 35 mm registrado no incluye el zoom digital: se usaron {used} mm en lugar de {recorded} mm.</translation>
    </message>
    <message>
        <location filename="../core/io/local_copy.py"/>
        <source>the file cannot be opened</source>
        <translation>no se puede abrir el archivo</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates are not numbers (no GPS fix) and were ignored.</source>
        <translation>Las coordenadas registradas no son números (sin señal GPS) y se han ignorado.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates lie outside the range of latitude and longitude and were ignored.</source>
        <translation>Las coordenadas registradas están fuera del intervalo de latitud y longitud y no se tuvieron en cuenta.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The recorded coordinates are 0, 0 (no GPS fix) and were ignored.</source>
        <translation>Las coordenadas registradas son 0, 0 (sin señal GPS) y se han ignorado.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The hemisphere is not recorded; north and east were assumed where it is missing.</source>
        <translation>El hemisferio no está registrado; donde falta se han supuesto norte y este.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The GPS had no fix when the photo was taken, so the position may be that of another place.</source>
        <translation>El GPS no tenía señal cuando se tomó la foto, por lo que la posición puede ser la de otro lugar.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The GPS position is imprecise (DOP {dop}): an error of {metres} m was assumed.</source>
        <translation>La posición GPS es imprecisa (DOP {dop}): se supuso un error de {metres} m.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The picture is a panorama of {angle} degrees, not that of one lens; its field of view is unknown.</source>
        <translation>La imagen es un panorama de {angle} grados, no la de un solo objetivo; su ángulo de visión es desconocido.</translation>
    </message>
    <message>
        <location filename="../core/io/metadata.py"/>
        <source>The picture is a panorama, not that of one lens; its field of view is unknown.</source>
        <translation>La imagen es un panorama, no la de un solo objetivo; su ángulo de visión es desconocido.</translation>
    </message>
    <message>
        <location filename="../core/io/osm_summits.py"/>
        <source>The OpenStreetMap extract {path} cannot be read: {reason}. Download it again.</source>
        <translation>No se puede leer el extracto de OpenStreetMap {path}: {reason}. Descárguelo de nuevo.</translation>
    </message>
    <message>
        <location filename="../core/io/osm_summits.py"/>
        <source>it has another format</source>
        <translation>tiene otro formato</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>it is damaged or incomplete. Copy it again from its source.</source>
        <translation>está dañado o incompleto. Cópielo de nuevo desde su origen.</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>it is too large for this computer's memory. Reduce its size.</source>
        <translation>es demasiado grande para la memoria de este ordenador. Reduzca la imagen.</translation>
    </message>
    <message>
        <location filename="../core/io/pixels.py"/>
        <source>HEIC needs the Python package pillow-heif. {hint}, or export it as JPEG.</source>
        <translation>HEIC necesita el paquete de Python pillow-heif. {hint}, o expórtela como JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} does not exist. Check the path.</source>
        <translation>El MDE {path} no existe. Compruebe la ruta.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} is not a raster that GDAL can read. Choose an elevation raster.</source>
        <translation>El MDE {path} no es un ráster que GDAL pueda leer. Elija un ráster de altitudes.</translation>
    </message>
    <message>
        <location filename="../core/io/raster.py"/>
        <source>The DEM {path} is damaged ({reason}). Copy it again.</source>
        <translation>El MDE {path} está dañado ({reason}). Cópielo de nuevo.</translation>
    </message>
    <message>
        <location filename="../core/io/report_file.py"/>
        <location filename="../core/io/whole_file.py"/>
        <location filename="../core/io/write_raster.py"/>
        <source>the folder {folder} does not exist</source>
        <translation>la carpeta {folder} no existe</translation>
    </message>
    <message>
        <location filename="../core/io/report_file.py"/>
        <source>The report {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>No se puede escribir el informe {path}: {reason}. Elija otra carpeta o libere espacio.</translation>
    </message>
    <message>
        <location filename="../core/io/tiff_pages.py"/>
        <source>it is a raw file of a camera, which must be exported as JPEG first.</source>
        <translation>es un archivo en bruto (RAW) de una cámara, que antes debe exportarse como JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/tiff_pages.py"/>
        <source>its first page of {width} x {height} pixels is a thumbnail of a larger picture. Export that as JPEG.</source>
        <translation>su primera página de {width} x {height} píxeles es una miniatura de una imagen mayor. Expórtela como JPEG.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>The photo {path} cannot be written: its name must end in .jpg or .heic.</source>
        <translation>No se puede escribir la foto {path}: su nombre debe terminar en .jpg o .heic.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>Writing HEIC photographs</source>
        <translation>Escribir fotos HEIC</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>The photo {path} cannot be written: {reason}. Choose another folder or free some space.</source>
        <translation>No se puede escribir la foto {path}: {reason}. Elija otra carpeta o libere espacio.</translation>
    </message>
    <message>
        <location filename="../core/io/write_photo.py"/>
        <source>Writing photographs</source>
        <translation>Escribir fotos</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>cannot be created</source>
        <translation>no se puede crear</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>the folder {folder} is read-only</source>
        <translation>la carpeta {folder} es de solo lectura</translation>
    </message>
    <message>
        <location filename="../core/io/write_raster.py"/>
        <source>the disk may be full</source>
        <translation>puede que el disco esté lleno</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The photos taken nearby decide the heading: no other heading fits all of them.</source>
        <translation>Las fotos tomadas cerca deciden el rumbo: ningún otro encaja con todas.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>Photos taken nearby contradict this heading. Compare the overlays, or give an approximate heading or a landmark.</source>
        <translation>Fotos tomadas cerca contradicen este rumbo. Compare las superposiciones, o dé un rumbo aproximado o un punto de referencia.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The photos taken nearby suggest this heading but do not decide it. Check the overlay, or give an approximate heading or a landmark.</source>
        <translation>Las fotos tomadas cerca apuntan a este rumbo, pero no lo deciden. Compruebe la superposición, o dé un rumbo aproximado o un punto de referencia.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>Features that it shares with {photos} helped to find the heading.</source>
        <translation>Los rasgos que comparte con {photos} ayudaron a encontrar el rumbo.</translation>
    </message>
    <message>
        <location filename="../core/joint/answers.py"/>
        <source>The error of the compass that it shares with {count} photos of the same hour (such as {photo}) helped to find the heading.</source>
        <translation>El error de la brújula que comparte con {count} fotos de la misma hora (como {photo}) ayudó a encontrar el rumbo.</translation>
    </message>
    <message>
        <location filename="../core/locate/build.py"/>
        <source>The DEM has no heights in the area. Choose another area, or a DEM without voids there.</source>
        <translation>El MDE no tiene alturas en el área. Elija otra área o un MDE sin huecos en ella.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>From this place, the DEM horizon matches the skyline in {share} % of the columns; no place elsewhere in the area scores close.</source>
        <translation>Desde este lugar, el horizonte del MDE coincide con la línea del horizonte en el {share} % de las columnas; ningún otro lugar del área se le acerca.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>No place in the area fits the skyline clearly. The photo was probably not taken in this area, or clouds, trees or a narrow view hide what would decide it. Choose another area, or give a sky mask or the field of view.</source>
        <translation>Ningún lugar del área encaja claramente con la línea del horizonte. Probablemente la foto no se tomó en esta área, o nubes, árboles o una vista estrecha ocultan lo que decidiría. Elija otra área, o dé una máscara del cielo o el ángulo de visión.</translation>
    </message>
    <message>
        <location filename="../core/locate/judge.py"/>
        <source>This place fits best, but others in the area fit nearly as well, or the fit is weak. Compare the candidates, or choose a smaller area.</source>
        <translation>Este lugar es el que mejor encaja, pero otros del área encajan casi igual de bien, o el ajuste es débil. Compare los candidatos, o elija un área menor.</translation>
    </message>
    <message>
        <location filename="../core/locate/places.py"/>
        <source>The area needs an index of {needed} MB, and {limit} MB are allowed. Choose an area of at most {km2} km2, a wider spacing of the places, or a folder for the index, which then stays on disk.</source>
        <translation>El área necesita un índice de {needed} MB, y se permiten {limit} MB. Elija un área de como máximo {km2} km2, una separación mayor de los lugares o una carpeta para el índice, que entonces queda en el disco.</translation>
    </message>
    <message>
        <location filename="../core/locate/places.py"/>
        <source>No part of the area lies inside the DEM. Choose an area that the DEM covers, or another DEM.</source>
        <translation>Ninguna parte del área está dentro del MDE. Elija un área que el MDE cubra, u otro MDE.</translation>
    </message>
    <message>
        <location filename="../core/locating.py"/>
        <source>Hardly any column of the picture shows a boundary between sky and terrain.</source>
        <translation>Casi ninguna columna de la imagen muestra un límite entre cielo y terreno.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>At the landmark's heading the DEM horizon does not follow the skyline that was found in the picture. Check the landmark and the overlay, or give a second landmark, a sky mask or a drawn skyline.</source>
        <translation>Con el rumbo del punto de referencia, el horizonte del MDE no sigue la línea del horizonte hallada en la imagen. Compruebe el punto de referencia y la superposición, o dé un segundo punto de referencia, una máscara del cielo o una línea del horizonte dibujada.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies outside the picture of {width} x {height} pixels and was not used. Check that its pixel belongs to this picture, and not to a reduced or turned copy.</source>
        <translation>El punto de referencia {number} está fuera de la imagen de {width} x {height} píxeles y no se ha usado. Compruebe que su píxel pertenece a esta imagen y no a una copia reducida o girada.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} contradicts the picture, in which the skyline alone decides the heading: its map point lies {count} degrees in azimuth from its pixel. It was not used. Check the pixel and the map point.</source>
        <translation>El punto de referencia {number} contradice la imagen, en la que la línea del horizonte decide por sí sola el rumbo: su punto del mapa está a {count} grados de acimut de su píxel. No se ha usado. Compruebe el píxel y el punto del mapa.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies {count} pixels from its predicted position.</source>
        <translation>El punto de referencia {number} está a {count} píxeles de su posición prevista.</translation>
    </message>
    <message>
        <location filename="../core/match/landmarks.py"/>
        <source>Landmark {number} lies outside the view, {count} degrees in azimuth from the heading. Check the landmark and the position.</source>
        <translation>El punto de referencia {number} está fuera de la vista, con un acimut a {count} grados del rumbo. Compruebe el punto de referencia y la posición.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The skyline does not decide the heading, so the approximate heading is given back. Check the overlay, or give a landmark, a drawn skyline or a sky mask.</source>
        <translation>La línea del horizonte no decide el rumbo, por lo que se devuelve el rumbo aproximado. Compruebe la superposición, o indique un punto de referencia, una línea del horizonte dibujada o una máscara de cielo.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The mirror image of the photo fits the DEM better than the photo itself. If it was flipped (a slide scanned from the wrong side), flip it back and run again; else check the overlay.</source>
        <translation>La imagen especular de la foto se ajusta al MDE mejor que la propia foto. Si está invertida (una diapositiva escaneada por el lado equivocado), inviértala y vuelva a ejecutar; si no, compruebe la superposición.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>According to the DEM, the most distinct line in the picture is a nearby crest; the fainter line behind it was used as the skyline.</source>
        <translation>Según el MDE, la línea más marcada de la imagen es una cresta cercana; como línea del horizonte se usó la más débil que hay detrás.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>Hardly any column of the picture shows a boundary between sky and terrain. Use a photo with a skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>Casi ninguna columna de la imagen muestra un límite entre cielo y terreno. Use una foto con una línea del horizonte, o aporte una máscara del cielo o una línea dibujada.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The DEM has no terrain around this position. Use a DEM that reaches farther.</source>
        <translation>El MDE no tiene terreno alrededor de esta posición. Use un MDE que llegue más lejos.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>In {share} % of the frame the DEM ends or has voids before higher terrain can be ruled out. Use a larger DEM to make the heading more certain.</source>
        <translation>En el {share} % de la imagen el MDE termina o tiene vacíos antes de que se pueda descartar terreno más alto. Use un MDE mayor para que el rumbo sea más seguro.</translation>
    </message>
    <message>
        <location filename="../core/match/notes.py"/>
        <source>The photo's compass says {heading} degrees and took no part. If you trust it, use it as a hint (COMPASS).</source>
        <translation>La brújula de la foto indica {heading} grados y no se ha tenido en cuenta. Si confía en ella, úsela como indicio (COMPASS).</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The horizon is almost straight here, so it fits many headings. Give an approximate heading or a landmark.</source>
        <translation>El horizonte es aquí casi recto y encaja con muchos rumbos. Dé un rumbo aproximado o un punto de referencia.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The DEM horizon matches the skyline in {share} % of the columns; no other heading scores close.</source>
        <translation>El horizonte del MDE coincide con la línea del horizonte en el {share} % de las columnas; ningún otro rumbo obtiene una puntuación parecida.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>No heading fits the skyline. Check the position and the field of view, or give a sky mask, a drawn skyline, a landmark or an approximate heading.</source>
        <translation>Ningún rumbo encaja con la línea del horizonte. Compruebe la posición y el ángulo de visión, o dé una máscara del cielo, una línea dibujada, un punto de referencia o un rumbo aproximado.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>A heading of {heading} degrees fits nearly as well. Compare the overlays, or give an approximate heading or a landmark.</source>
        <translation>Un rumbo de {heading} grados encaja casi igual de bien. Compare las superposiciones, o dé un rumbo aproximado o un punto de referencia.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The fit is weak. Check the overlay, or give an approximate heading, a landmark or a sky mask.</source>
        <translation>El ajuste es débil. Compruebe la superposición, o dé un rumbo aproximado, un punto de referencia o una máscara del cielo.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The DEM horizon does not follow the skyline that was found in the picture. Check the overlay, or give a sky mask, a drawn skyline or an approximate heading.</source>
        <translation>El horizonte del MDE no sigue la línea del horizonte hallada en la imagen. Compruebe la superposición, o indique una máscara del cielo, una línea del horizonte dibujada o un rumbo aproximado.</translation>
    </message>
    <message>
        <location filename="../core/match/posterior.py"/>
        <source>The photo's compass says {heading} degrees, which contradicts the heading found. Check the overlay, use the compass as a hint (COMPASS), or give an approximate heading.</source>
        <translation>La brújula de la foto indica {heading} grados, lo que contradice el rumbo hallado. Compruebe la superposición, use la brújula como indicio (COMPASS) o indique un rumbo aproximado.</translation>
    </message>
    <message>
        <location filename="../core/match/prior.py"/>
        <source>The photo has no focal length (35 mm equivalent). Give the horizontal field of view in HFOV_FIELD.</source>
        <translation>La foto no tiene distancia focal (equivalente en 35 mm). Dé el ángulo de visión horizontal en HFOV_FIELD.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>The skyline or the DEM's horizon is a straight line, which cannot be matched. Use a photo that shows a mountain skyline.</source>
        <translation>La línea del horizonte o el horizonte del MDE es una recta, que no se puede ajustar. Use una foto que muestre una línea del horizonte de montañas.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>The paper method does not test its result. Check the overlay, or use the robust method.</source>
        <translation>El método del artículo no comprueba su resultado. Compruebe la superposición o use el método robusto.</translation>
    </message>
    <message>
        <location filename="../core/paper/match.py"/>
        <source>A skyline was found in only {share} % of the columns. Use a photo that shows more of the skyline, or supply a sky mask or a drawn skyline.</source>
        <translation>Solo se halló una línea del horizonte en el {share} % de las columnas. Use una foto que muestre más de ella, o aporte una máscara del cielo o una línea dibujada.</translation>
    </message>
    <message>
        <location filename="../core/paper/skyline.py"/>
        <source>The picture has no smooth region above a rough one.</source>
        <translation>La imagen no tiene una zona lisa sobre otra rugosa.</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>best guess</source>
        <translation>mejor conjetura</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>most likely of several</source>
        <translation>el más probable de varios</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Pitch</source>
        <translation>Cabeceo</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Roll</source>
        <translation>Alabeo</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>HFOV</source>
        <translation>Ángulo hor.</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>Compass − found</source>
        <translation>Brújula − hallado</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Eye elevation</source>
        <translation>Elevación del ojo</translation>
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
        <translation>probabilidad</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>{chance} within 3°</source>
        <translation>{chance} dentro de 3°</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>picture with extracted skyline and DEM horizons</source>
        <translation>imagen con la línea del horizonte extraída y los horizontes del MDE</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>extracted</source>
        <translation>extraída</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>DEM at {heading}</source>
        <translation>MDE a {heading}</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/overview.py"/>
        <source>alternatives</source>
        <translation>alternativas</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <location filename="../core/report/facts.py"/>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>Camera heading and visible ground</source>
        <translation>Rumbo de la cámara y terreno visible</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>All numbers and the DEM horizon</source>
        <translation>Todos los números y el horizonte del MDE</translation>
    </message>
    <message>
        <location filename="../core/report/card.py"/>
        <source>All numbers</source>
        <translation>Todos los números</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>All photographs</source>
        <translation>Todas las fotografías</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Previous page</source>
        <translation>Página anterior</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Next page</source>
        <translation>Página siguiente</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>photographs {first} to {last}</source>
        <translation>fotografías {first} a {last}</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>whole map</source>
        <translation>mapa entero</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>only this section of the map</source>
        <translation>solo esta parte del mapa</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Search names, cameras, dates and reasons</source>
        <translation>Buscar nombres, cámaras, fechas y motivos</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>Pages of cards</source>
        <translation>Páginas de fichas</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>{count} of {all} photographs</source>
        <translation>{count} de {all} fotografías</translation>
    </message>
    <message>
        <location filename="../core/report/collection.py"/>
        <source>{first} to {last}</source>
        <translation>{first} a {last}</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Recorded heading minus heading found, of accepted and confirmed photographs. Bias is the median with its 90 % interval, spread is robust; both leave out readings farther than {limit} from the others.</source>
        <translation>Rumbo registrado menos rumbo hallado de las fotografías aceptadas y confirmadas. El sesgo es la mediana con su intervalo del 90 %, la dispersión es robusta; ambos omiten las lecturas que se apartan más de {limit} de las demás.</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Compasses</source>
        <translation>Brújulas</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Bias</source>
        <translation>Sesgo</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Spread</source>
        <translation>Dispersión</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Off by more than 30°</source>
        <translation>Desviadas más de 30°</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Near +90°, −90°, 180°</source>
        <translation>Cerca de +90°, −90°, 180°</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>Drift per hour</source>
        <translation>Deriva por hora</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <source>(turned)</source>
        <translation>(girada)</translation>
    </message>
    <message>
        <location filename="../core/report/compass.py"/>
        <location filename="../core/report/facts.py"/>
        <source>{low} to {high}</source>
        <translation>{low} a {high}</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>failed</source>
        <translation>fallida</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Other values</source>
        <translation>Otros valores</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Lens</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Compass</source>
        <translation>Brújula</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Position and elevation</source>
        <translation>Posición y altitud</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>DEM horizon</source>
        <translation>Horizonte del MDE</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Heading, true</source>
        <translation>Rumbo, geográfico</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>90 % interval</source>
        <translation>Intervalo del 90 %</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pitch, + up</source>
        <translation>Cabeceo, + hacia arriba</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Roll, + right side down</source>
        <translation>Alabeo, + lado derecho abajo</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Alternative {rank}</source>
        <translation>Alternativa {rank}</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Within 3° of the truth</source>
        <translation>A menos de 3° de la verdad</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Score of alternative 2</source>
        <translation>Puntuación de la alternativa 2</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>NCC of the second peak</source>
        <translation>NCC del segundo pico</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Sharpness of the peak</source>
        <translation>Nitidez del pico</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Residual, median</source>
        <translation>Residuo, mediana</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Columns compared</source>
        <translation>Columnas comparadas</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Horizontal field of view</source>
        <translation>Ángulo de visión horizontal</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Vertical field of view</source>
        <translation>Ángulo de visión vertical</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Focal length</source>
        <translation>Distancia focal</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>35 mm equivalent, used</source>
        <translation>Equivalente de 35 mm, usado</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>35 mm equivalent, EXIF</source>
        <translation>Equivalente de 35 mm, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distortion k1, k2</source>
        <translation>Distorsión k1, k2</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>from true north</source>
        <translation>desde el norte geográfico</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>from magnetic north</source>
        <translation>desde el norte magnético</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>reference unknown</source>
        <translation>referencia desconocida</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Recorded</source>
        <translation>Registrado</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Converted to true north</source>
        <translation>Convertido al norte geográfico</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Recorded minus found</source>
        <translation>Registrado menos hallado</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Pitch of the gimbal, + up</source>
        <translation>Cabeceo del gimbal, + hacia arriba</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Roll of the gimbal, + right side down</source>
        <translation>Alabeo del gimbal, + lado derecho abajo</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Position error, EXIF</source>
        <translation>Error de posición, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Eye elevation, used</source>
        <translation>Elevación del ojo, usada</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>DEM under the eye</source>
        <translation>MDE bajo el ojo</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Eye above the DEM</source>
        <translation>Ojo sobre el MDE</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Altitude, EXIF</source>
        <translation>Altitud, EXIF</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>sea level</source>
        <translation>nivel del mar</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>below sea level</source>
        <translation>bajo el nivel del mar</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>ellipsoid</source>
        <translation>elipsoide</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distance in view, median</source>
        <translation>Distancia a la vista, mediana</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Distance in view, farthest</source>
        <translation>Distancia a la vista, máxima</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Cut by the DEM's edge in view</source>
        <translation>Cortado a la vista por el borde del MDE</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <location filename="../core/report/horizon.py"/>
        <source>Cell size</source>
        <translation>Tamaño de celda</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Grid north from true north</source>
        <translation>Norte de cuadrícula desde el norte geográfico</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Path</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Size, upright</source>
        <translation>Tamaño, derecho</translation>
    </message>
    <message>
        <location filename="../core/report/facts.py"/>
        <source>Taken, camera's time</source>
        <translation>Tomada, hora de la cámara</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Place and horizon</source>
        <translation>Lugar y horizonte</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Eye and DEM</source>
        <translation>Ojo y MDE</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>1 place</source>
        <translation>1 lugar</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>{count} places</source>
        <translation>{count} lugares</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Highest horizon</source>
        <translation>Horizonte más alto</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>at azimuth</source>
        <translation>en el acimut</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Mean horizon</source>
        <translation>Horizonte medio</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Median distance</source>
        <translation>Distancia mediana</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Farthest</source>
        <translation>Más lejano</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Cut by DEM edge</source>
        <translation>Cortado por el borde del MDE</translation>
    </message>
    <message>
        <location filename="../core/report/horizon.py"/>
        <source>Void</source>
        <translation>Vacío</translation>
    </message>
    <message>
        <location filename="../core/report/orientability.py"/>
        <source>Expected error of the heading</source>
        <translation>Error esperado del rumbo</translation>
    </message>
    <message>
        <location filename="../core/report/orientability.py"/>
        <source>Field of view {hfov}°</source>
        <translation>Ángulo de visión {hfov}°</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Heading</source>
        <translation>Rumbo</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Within 3°</source>
        <translation>Dentro de 3°</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Second best</source>
        <translation>Segundo mejor</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>Residual</source>
        <translation>Residuo</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>all</source>
        <translation>todas</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>evidence</source>
        <translation>indicios</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>DEM horizon, answer</source>
        <translation>horizonte del MDE, respuesta</translation>
    </message>
    <message>
        <location filename="../core/report/overview.py"/>
        <source>whole picture</source>
        <translation>imagen entera</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Parameters, DEM and software</source>
        <translation>Parámetros, MDE y programa</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>language code: en</source>
        <translation>código de idioma: es</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>Made by {software}.</source>
        <translation>Hecho por {software}.</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>The cards are in the folder {folder} beside this page: keep both together. They load nothing from the network.</source>
        <translation>Las fichas están en la carpeta {folder}, junto a esta página: mantenga ambas juntas. No cargan nada de la red.</translation>
    </message>
    <message>
        <location filename="../core/report/page.py"/>
        <source>This page is self-contained and loads nothing from the network. Keys: j for the next photo, k for the previous one.</source>
        <translation>Esta página es autónoma y no carga nada de la red. Teclas: j para la foto siguiente, k para la anterior.</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>Compass minus heading found</source>
        <translation>Brújula menos rumbo hallado</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>{count} readings, median difference {median}.</source>
        <translation>{count} lecturas, diferencia mediana {median}.</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>hour of the day, camera's clock</source>
        <translation>hora del día, reloj de la cámara</translation>
    </message>
    <message>
        <location filename="../core/report/readings.py"/>
        <source>most in one bar: {count}</source>
        <translation>barra más alta: {count}</translation>
    </message>
    <message>
        <location filename="../core/skyline/evidence.py"/>
        <source>The picture has a single colour.</source>
        <translation>La imagen tiene un solo color.</translation>
    </message>
    <message>
        <location filename="../core/skyline/evidence.py"/>
        <source>The picture is only {width} x {height} pixels.</source>
        <translation>La imagen tiene solo {width} x {height} píxeles.</translation>
    </message>
    <message>
        <location filename="../core/skyline/given.py"/>
        <source>The drawn skyline has fewer than two points.</source>
        <translation>La línea del horizonte dibujada tiene menos de dos puntos.</translation>
    </message>
    <message>
        <location filename="../core/skyline/given.py"/>
        <source>The supplied skyline or sky mask has no change from sky to terrain.</source>
        <translation>La línea del horizonte o la máscara del cielo aportada no tiene paso de cielo a terreno.</translation>
    </message>
    <message>
        <location filename="../core/skyline/plausible.py"/>
        <source>The picture shows no skyline: no line separates sky from terrain.</source>
        <translation>La imagen no muestra ninguna línea del horizonte: ninguna línea separa el cielo del terreno.</translation>
    </message>
    <message>
        <location filename="../core/skyline/plausible.py"/>
        <source>The picture shows no mountain skyline: its lines are level and upright, as in a room or on a page.</source>
        <translation>La imagen no muestra ninguna línea de montañas: sus líneas son horizontales y verticales, como en una habitación o en una página.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The clock cannot be determined: only {count} photos with a time, at least a minute apart, show a skyline, and {least} are needed. Give the clock's offset.</source>
        <translation>No se puede determinar el reloj: solo {count} fotos con hora, separadas al menos un minuto, muestran una línea del horizonte y se necesitan {least}. Indique el desfase del reloj.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The clock cannot be determined from the skylines: other offsets fit as well. Give the clock's offset, or more photos with a clear skyline from different places.</source>
        <translation>No se puede determinar el reloj a partir de las líneas del horizonte: otros desfases encajan igual de bien. Indique el desfase del reloj, o añada fotos con una línea del horizonte clara desde lugares distintos.</translation>
    </message>
    <message>
        <location filename="../core/track/clock.py"/>
        <source>The camera's clock is ahead by {offset} s (90 % interval: {lo} to {hi} s); {count} photos agree.</source>
        <translation>El reloj de la cámara adelanta {offset} s (intervalo del 90 %: de {lo} a {hi} s); {count} fotos coinciden.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The track has fewer than two points with a time. Choose a recorded track, not a planned route.</source>
        <translation>El track tiene menos de dos puntos con hora. Elija un track grabado, no una ruta planificada.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The photo was taken {time} before the track begins.</source>
        <translation>La foto se tomó {time} antes de que empiece el track.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The photo was taken {time} after the track ends.</source>
        <translation>La foto se tomó {time} después de que termine el track.</translation>
    </message>
    <message>
        <location filename="../core/track/track.py"/>
        <source>The track has a gap of {time} around the photo.</source>
        <translation>El track tiene un hueco de {time} alrededor de la foto.</translation>
    </message>
    <message>
        <location filename="../core/track/zone.py"/>
        <source>The time zone {text} is not known. Write it as +05:45 or as Asia/Kathmandu.</source>
        <translation>La zona horaria {text} no se conoce. Escríbala como +05:45 o como Asia/Kathmandu.</translation>
    </message>
    <message>
        <location filename="../core/viewshed/geometry.py"/>
        <source>The DEM's coordinate system distorts sight lines too strongly here. Use a DEM in a projected coordinate system, such as UTM.</source>
        <translation>El sistema de coordenadas del MDE deforma aquí demasiado las líneas de visión. Use un MDE en un sistema de coordenadas proyectado, como UTM.</translation>
    </message>
    <message>
        <location filename="../core/viewshed/geometry.py"/>
        <source>The DEM's coordinate system bends sight lines too strongly here (close to a pole of its grid). Use a DEM in a projected coordinate system, such as UTM or polar stereographic.</source>
        <translation>El sistema de coordenadas del MDE curva aquí demasiado las líneas de visión (cerca de un polo de su malla). Use un MDE en un sistema proyectado, como UTM o estereográfico polar.</translation>
    </message>
    <message>
        <location filename="../core/workers/pool.py"/>
        <source>The process that worked on this photo ended unexpectedly, perhaps because memory ran out. Run this photo again by itself, or set a smaller number of worker processes.</source>
        <translation>El proceso que trabajaba en esta foto terminó inesperadamente, quizá por falta de memoria. Vuelva a procesar esta foto sola o elija menos procesos de trabajo.</translation>
    </message>
    <message>
        <location filename="../core/workers/team.py"/>
        <source>No worker processes could be started ({reason}), so one process does all the work.</source>
        <translation>No se pudieron iniciar procesos de trabajo ({reason}), por lo que un solo proceso hace todo el trabajo.</translation>
    </message>
</context>
</TS>
