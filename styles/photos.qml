<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis simplifyDrawingTol="1" labelsEnabled="0" simplifyLocal="1" simplifyDrawingHints="1" simplifyAlgorithm="0" simplifyMaxScale="1" symbologyReferenceScale="-1" minScale="100000000" version="3.22.16-Białowieża" styleCategories="AllStyleCategories" hasScaleBasedVisibilityFlag="0" maxScale="0" readOnly="0">
  <flags>
    <Identifiable>1</Identifiable>
    <Removable>1</Removable>
    <Searchable>1</Searchable>
    <Private>0</Private>
  </flags>
  <temporal limitMode="0" startField="" durationField="" enabled="0" endExpression="" startExpression="" durationUnit="min" fixedDuration="0" accumulate="0" mode="0" endField="">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <renderer-v2 type="singleSymbol" referencescale="-1" enableorderby="0" forceraster="0" symbollevels="0">
    <symbols>
      <symbol type="marker" force_rhr="0" clip_to_extent="1" alpha="1" name="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer class="GeometryGenerator" enabled="1" locked="0" pass="0">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Fill"/>
            <Option type="QString" name="geometryModifier" value="if(&quot;direction&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;direction&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
            <Option type="QString" name="units" value="MM"/>
          </Option>
          <prop k="SymbolType" v="Fill"/>
          <prop k="geometryModifier" v="if(&quot;direction&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;direction&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
          <prop k="units" v="MM"/>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol type="fill" force_rhr="0" clip_to_extent="1" alpha="1" name="@0@0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleFill" enabled="1" locked="0" pass="0">
              <Option type="Map">
                <Option type="QString" name="border_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="color" value="47,111,159,70"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="offset" value="0,0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="outline_color" value="47,111,159,255"/>
                <Option type="QString" name="outline_style" value="solid"/>
                <Option type="QString" name="outline_width" value="0.3"/>
                <Option type="QString" name="outline_width_unit" value="MM"/>
                <Option type="QString" name="style" value="solid"/>
              </Option>
              <prop k="border_width_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="color" v="47,111,159,70"/>
              <prop k="joinstyle" v="bevel"/>
              <prop k="offset" v="0,0"/>
              <prop k="offset_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="offset_unit" v="MM"/>
              <prop k="outline_color" v="47,111,159,255"/>
              <prop k="outline_style" v="solid"/>
              <prop k="outline_width" v="0.3"/>
              <prop k="outline_width_unit" v="MM"/>
              <prop k="style" v="solid"/>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="fillColor">
                      <Option type="bool" name="active" value="true"/>
                      <Option type="QString" name="expression" value="if($id is null, '0,0,0,0', '47,111,159,70')"/>
                      <Option type="int" name="type" value="3"/>
                    </Option>
                    <Option type="Map" name="outlineColor">
                      <Option type="bool" name="active" value="true"/>
                      <Option type="QString" name="expression" value="if($id is null, '0,0,0,0', '47,111,159,255')"/>
                      <Option type="int" name="type" value="3"/>
                    </Option>
                  </Option>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="SvgMarker" enabled="1" locked="0" pass="0">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="color" value="47,111,159,255"/>
            <Option type="QString" name="fixedAspectRatio" value="0"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="name" value="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PHBhdGggZD0iTTQgMTEgSDggTDkuNSAzIEgxNC41IEwxNiAxMSBIMjAgQTIgMiAwIDAgMSAyMiAxMyBWMjAgQTIgMiAwIDAgMSAyMCAyMiBINCBBMiAyIDAgMCAxIDIgMjAgVjEzIEEyIDIgMCAwIDEgNCAxMSBaIiBmaWxsPSJwYXJhbShmaWxsKSIgc3Ryb2tlPSJwYXJhbShvdXRsaW5lKSIgc3Ryb2tlLXdpZHRoPSJwYXJhbShvdXRsaW5lLXdpZHRoKSIvPjwvc3ZnPg=="/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="255,255,255,255"/>
            <Option type="QString" name="outline_width" value="0.2"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option name="parameters"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="5"/>
            <Option type="QString" name="size_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="vertical_anchor_point" value="1"/>
          </Option>
          <prop k="angle" v="0"/>
          <prop k="color" v="47,111,159,255"/>
          <prop k="fixedAspectRatio" v="0"/>
          <prop k="horizontal_anchor_point" v="1"/>
          <prop k="name" v="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PHBhdGggZD0iTTQgMTEgSDggTDkuNSAzIEgxNC41IEwxNiAxMSBIMjAgQTIgMiAwIDAgMSAyMiAxMyBWMjAgQTIgMiAwIDAgMSAyMCAyMiBINCBBMiAyIDAgMCAxIDIgMjAgVjEzIEEyIDIgMCAwIDEgNCAxMSBaIiBmaWxsPSJwYXJhbShmaWxsKSIgc3Ryb2tlPSJwYXJhbShvdXRsaW5lKSIgc3Ryb2tlLXdpZHRoPSJwYXJhbShvdXRsaW5lLXdpZHRoKSIvPjwvc3ZnPg=="/>
          <prop k="offset" v="0,0"/>
          <prop k="offset_map_unit_scale" v="3x:0,0,0,0,0,0"/>
          <prop k="offset_unit" v="MM"/>
          <prop k="outline_color" v="255,255,255,255"/>
          <prop k="outline_width" v="0.2"/>
          <prop k="outline_width_map_unit_scale" v="3x:0,0,0,0,0,0"/>
          <prop k="outline_width_unit" v="MM"/>
          <prop k="parameters" v=""/>
          <prop k="scale_method" v="diameter"/>
          <prop k="size" v="5"/>
          <prop k="size_map_unit_scale" v="3x:0,0,0,0,0,0"/>
          <prop k="size_unit" v="MM"/>
          <prop k="vertical_anchor_point" v="1"/>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option type="Map" name="properties">
                <Option type="Map" name="angle">
                  <Option type="bool" name="active" value="true"/>
                  <Option type="QString" name="expression" value="coalesce(&quot;direction&quot;, 0)"/>
                  <Option type="int" name="type" value="3"/>
                </Option>
              </Option>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </symbols>
    <rotation/>
    <sizescale/>
  </renderer-v2>
  <customproperties>
    <Option/>
  </customproperties>
  <blendMode>0</blendMode>
  <featureBlendMode>0</featureBlendMode>
  <layerOpacity>1</layerOpacity>
  <geometryOptions geometryPrecision="0" removeDuplicateNodes="0">
    <activeChecks type="StringList">
      <Option type="QString" value=""/>
    </activeChecks>
    <checkConfiguration/>
  </geometryOptions>
  <legend type="default-vector" showLabelLegend="0"/>
  <referencedLayers/>
  <fieldConfiguration>
    <field name="photo" configurationFlags="None">
      <editWidget type="ExternalResource">
        <config>
          <Option type="Map">
            <Option type="int" name="DocumentViewer" value="0"/>
            <Option type="bool" name="FileWidget" value="true"/>
            <Option type="bool" name="FileWidgetButton" value="true"/>
            <Option type="QString" name="FileWidgetFilter" value=""/>
            <Option type="bool" name="FullUrl" value="true"/>
            <Option type="int" name="RelativeStorage" value="0"/>
            <Option type="int" name="StorageMode" value="0"/>
            <Option type="bool" name="UseLink" value="true"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="filename" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="directory" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="altitude" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="double" name="Max" value="1e+09"/>
            <Option type="double" name="Min" value="-1e+09"/>
            <Option type="int" name="Precision" value="1"/>
            <Option type="double" name="Step" value="0.1"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="direction" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="double" name="Max" value="1e+09"/>
            <Option type="double" name="Min" value="-1e+09"/>
            <Option type="int" name="Precision" value="1"/>
            <Option type="double" name="Step" value="0.1"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="rotation" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="longitude" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="latitude" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="timestamp" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="f35" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="double" name="Max" value="1e+09"/>
            <Option type="double" name="Min" value="-1e+09"/>
            <Option type="int" name="Precision" value="1"/>
            <Option type="double" name="Step" value="0.1"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="hfov" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="double" name="Max" value="1e+09"/>
            <Option type="double" name="Min" value="-1e+09"/>
            <Option type="int" name="Precision" value="1"/>
            <Option type="double" name="Step" value="0.1"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="vfov" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="double" name="Max" value="1e+09"/>
            <Option type="double" name="Min" value="-1e+09"/>
            <Option type="int" name="Precision" value="1"/>
            <Option type="double" name="Step" value="0.1"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="width" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="height" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="dir_ref" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="h_acc" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="double" name="Max" value="1e+09"/>
            <Option type="double" name="Min" value="-1e+09"/>
            <Option type="int" name="Precision" value="1"/>
            <Option type="double" name="Step" value="0.1"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="camera" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="preview" configurationFlags="None">
      <editWidget type="ExternalResource">
        <config>
          <Option type="Map">
            <Option type="QString" name="DefaultRoot" value=""/>
            <Option type="int" name="DocumentViewer" value="1"/>
            <Option type="int" name="DocumentViewerHeight" value="220"/>
            <Option type="int" name="DocumentViewerWidth" value="0"/>
            <Option type="bool" name="FileWidget" value="false"/>
            <Option type="bool" name="FileWidgetButton" value="false"/>
            <Option type="Map" name="PropertyCollection">
              <Option type="invalid" name="name"/>
              <Option type="Map" name="properties">
                <Option type="Map" name="propertyRootPath">
                  <Option type="bool" name="active" value="true"/>
                  <Option type="QString" name="expression" value="file_path(layer_property(@layer, 'path'))"/>
                  <Option type="int" name="type" value="3"/>
                </Option>
              </Option>
              <Option type="QString" name="type" value="collection"/>
            </Option>
            <Option type="int" name="RelativeStorage" value="2"/>
            <Option type="int" name="StorageMode" value="0"/>
          </Option>
        </config>
      </editWidget>
    </field>
  </fieldConfiguration>
  <aliases>
    <alias name="Photo" field="photo" index="0"/>
    <alias name="Name" field="filename" index="1"/>
    <alias name="Folder" field="directory" index="2"/>
    <alias name="GPS altitude (m)" field="altitude" index="3"/>
    <alias name="Recorded heading (°)" field="direction" index="4"/>
    <alias name="Rotation by EXIF (°)" field="rotation" index="5"/>
    <alias name="Longitude (°)" field="longitude" index="6"/>
    <alias name="Latitude (°)" field="latitude" index="7"/>
    <alias name="Taken at (camera's local time)" field="timestamp" index="8"/>
    <alias name="35 mm equivalent focal length (mm)" field="f35" index="9"/>
    <alias name="Horizontal field of view (°)" field="hfov" index="10"/>
    <alias name="Vertical field of view (°)" field="vfov" index="11"/>
    <alias name="Width of the upright picture (px)" field="width" index="12"/>
    <alias name="Height of the upright picture (px)" field="height" index="13"/>
    <alias name="Recorded heading counts from (T true, M magnetic north)" field="dir_ref" index="14"/>
    <alias name="GPS horizontal error (m)" field="h_acc" index="15"/>
    <alias name="Camera" field="camera" index="16"/>
    <alias name="Picture" field="preview" index="17"/>
  </aliases>
  <defaults>
    <default expression="" field="photo" applyOnUpdate="0"/>
    <default expression="" field="filename" applyOnUpdate="0"/>
    <default expression="" field="directory" applyOnUpdate="0"/>
    <default expression="" field="altitude" applyOnUpdate="0"/>
    <default expression="" field="direction" applyOnUpdate="0"/>
    <default expression="" field="rotation" applyOnUpdate="0"/>
    <default expression="" field="longitude" applyOnUpdate="0"/>
    <default expression="" field="latitude" applyOnUpdate="0"/>
    <default expression="" field="timestamp" applyOnUpdate="0"/>
    <default expression="" field="f35" applyOnUpdate="0"/>
    <default expression="" field="hfov" applyOnUpdate="0"/>
    <default expression="" field="vfov" applyOnUpdate="0"/>
    <default expression="" field="width" applyOnUpdate="0"/>
    <default expression="" field="height" applyOnUpdate="0"/>
    <default expression="" field="dir_ref" applyOnUpdate="0"/>
    <default expression="" field="h_acc" applyOnUpdate="0"/>
    <default expression="" field="camera" applyOnUpdate="0"/>
    <default expression="" field="preview" applyOnUpdate="0"/>
  </defaults>
  <constraints>
    <constraint unique_strength="0" exp_strength="0" field="photo" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="filename" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="directory" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="altitude" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="direction" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="rotation" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="longitude" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="latitude" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="timestamp" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="f35" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="hfov" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="vfov" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="width" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="height" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="dir_ref" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="h_acc" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="camera" notnull_strength="0" constraints="0"/>
    <constraint unique_strength="0" exp_strength="0" field="preview" notnull_strength="0" constraints="0"/>
  </constraints>
  <constraintExpressions>
    <constraint desc="" field="photo" exp=""/>
    <constraint desc="" field="filename" exp=""/>
    <constraint desc="" field="directory" exp=""/>
    <constraint desc="" field="altitude" exp=""/>
    <constraint desc="" field="direction" exp=""/>
    <constraint desc="" field="rotation" exp=""/>
    <constraint desc="" field="longitude" exp=""/>
    <constraint desc="" field="latitude" exp=""/>
    <constraint desc="" field="timestamp" exp=""/>
    <constraint desc="" field="f35" exp=""/>
    <constraint desc="" field="hfov" exp=""/>
    <constraint desc="" field="vfov" exp=""/>
    <constraint desc="" field="width" exp=""/>
    <constraint desc="" field="height" exp=""/>
    <constraint desc="" field="dir_ref" exp=""/>
    <constraint desc="" field="h_acc" exp=""/>
    <constraint desc="" field="camera" exp=""/>
    <constraint desc="" field="preview" exp=""/>
  </constraintExpressions>
  <expressionfields/>
  <attributeactions/>
  <attributetableconfig sortOrder="0" sortExpression="" actionWidgetStyle="dropDown">
    <columns/>
  </attributetableconfig>
  <conditionalstyles>
    <rowstyles/>
    <fieldstyles/>
  </conditionalstyles>
  <storedexpressions/>
  <editform tolerant="1"></editform>
  <editforminit/>
  <editforminitcodesource>0</editforminitcodesource>
  <editforminitfilepath></editforminitfilepath>
  <editforminitcode><![CDATA[]]></editforminitcode>
  <featformsuppress>0</featformsuppress>
  <editorlayout>tablayout</editorlayout>
  <attributeEditorForm>
    <attributeEditorContainer groupBox="0" visibilityExpressionEnabled="0" name="Photo" visibilityExpression="" showLabel="1" columnCount="1">
      <attributeEditorField name="preview" showLabel="1" index="17"/>
      <attributeEditorField name="filename" showLabel="1" index="1"/>
      <attributeEditorField name="direction" showLabel="1" index="4"/>
      <attributeEditorField name="dir_ref" showLabel="1" index="14"/>
      <attributeEditorField name="timestamp" showLabel="1" index="8"/>
      <attributeEditorField name="camera" showLabel="1" index="16"/>
      <attributeEditorField name="f35" showLabel="1" index="9"/>
      <attributeEditorField name="hfov" showLabel="1" index="10"/>
      <attributeEditorField name="vfov" showLabel="1" index="11"/>
      <attributeEditorField name="width" showLabel="1" index="12"/>
      <attributeEditorField name="height" showLabel="1" index="13"/>
      <attributeEditorField name="rotation" showLabel="1" index="5"/>
      <attributeEditorField name="photo" showLabel="1" index="0"/>
      <attributeEditorField name="directory" showLabel="1" index="2"/>
    </attributeEditorContainer>
    <attributeEditorContainer groupBox="0" visibilityExpressionEnabled="0" name="Place" visibilityExpression="" showLabel="1" columnCount="1">
      <attributeEditorField name="altitude" showLabel="1" index="3"/>
      <attributeEditorField name="h_acc" showLabel="1" index="15"/>
      <attributeEditorField name="longitude" showLabel="1" index="6"/>
      <attributeEditorField name="latitude" showLabel="1" index="7"/>
    </attributeEditorContainer>
  </attributeEditorForm>
  <editable/>
  <labelOnTop>
    <field name="preview" labelOnTop="1"/>
  </labelOnTop>
  <reuseLastValue/>
  <dataDefinedFieldProperties/>
  <widgets/>
  <previewExpression>file_name("photo")</previewExpression>
  <mapTip>&lt;img src="file:///[% replace(replace(replace(replace(replace(replace(replace(with_variable('beside', file_path(layer_property(@layer, 'path')) || '/' || attribute($currentfeature, 'preview'), if(file_exists(@beside), @beside, coalesce(attribute($currentfeature, 'preview'), "photo"))), '\\', '/'), '%', '%25'), '#', '%23'), '?', '%3F'), '&amp;', '&amp;amp;'), '&lt;', '&amp;lt;'), '"', '&amp;quot;') %]" width="320"/>&lt;br/>[% replace(replace(replace(file_name("photo"), '&amp;', '&amp;amp;'), '&lt;', '&amp;lt;'), '"', '&amp;quot;') %] [% coalesce('recorded ' || round("direction", 1) || '°', '') %]</mapTip>
  <layerGeometryType>0</layerGeometryType>
</qgis>
