<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis minScale="100000000" readOnly="0" simplifyMaxScale="1" simplifyDrawingHints="1" hasScaleBasedVisibilityFlag="0" styleCategories="AllStyleCategories" simplifyAlgorithm="0" maxScale="0" labelsEnabled="0" symbologyReferenceScale="-1" simplifyDrawingTol="1" simplifyLocal="1" version="3.22.16-Białowieża">
  <flags>
    <Identifiable>1</Identifiable>
    <Removable>1</Removable>
    <Searchable>1</Searchable>
    <Private>0</Private>
  </flags>
  <temporal endExpression="" durationField="" durationUnit="min" fixedDuration="0" startField="" accumulate="0" endField="" startExpression="" mode="0" enabled="0" limitMode="0">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <renderer-v2 type="singleSymbol" forceraster="0" enableorderby="0" symbollevels="0" referencescale="-1">
    <symbols>
      <symbol name="0" alpha="1" clip_to_extent="1" type="marker" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" type="QString" value=""/>
            <Option name="properties"/>
            <Option name="type" type="QString" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator">
          <Option type="Map">
            <Option name="SymbolType" type="QString" value="Fill"/>
            <Option name="geometryModifier" type="QString" value="if(&quot;direction&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;direction&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
            <Option name="units" type="QString" value="MM"/>
          </Option>
          <prop k="SymbolType" v="Fill"/>
          <prop k="geometryModifier" v="if(&quot;direction&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;direction&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
          <prop k="units" v="MM"/>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol name="@0@0" alpha="1" clip_to_extent="1" type="fill" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option name="name" type="QString" value=""/>
                <Option name="properties"/>
                <Option name="type" type="QString" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleFill">
              <Option type="Map">
                <Option name="border_width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="color" type="QString" value="47,111,159,70"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="offset" type="QString" value="0,0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="outline_color" type="QString" value="47,111,159,255"/>
                <Option name="outline_style" type="QString" value="solid"/>
                <Option name="outline_width" type="QString" value="0.3"/>
                <Option name="outline_width_unit" type="QString" value="MM"/>
                <Option name="style" type="QString" value="solid"/>
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
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties" type="Map">
                    <Option name="fillColor" type="Map">
                      <Option name="active" type="bool" value="true"/>
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '47,111,159,70')"/>
                      <Option name="type" type="int" value="3"/>
                    </Option>
                    <Option name="outlineColor" type="Map">
                      <Option name="active" type="bool" value="true"/>
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '47,111,159,255')"/>
                      <Option name="type" type="int" value="3"/>
                    </Option>
                  </Option>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="SvgMarker">
          <Option type="Map">
            <Option name="angle" type="QString" value="0"/>
            <Option name="color" type="QString" value="47,111,159,255"/>
            <Option name="fixedAspectRatio" type="QString" value="0"/>
            <Option name="horizontal_anchor_point" type="QString" value="1"/>
            <Option name="name" type="QString" value="base64:PHN2ZyB4bWxucz0iaHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmciIHZpZXdCb3g9IjAgMCAyNCAyNCI+PHBhdGggZD0iTTQgMTEgSDggTDkuNSAzIEgxNC41IEwxNiAxMSBIMjAgQTIgMiAwIDAgMSAyMiAxMyBWMjAgQTIgMiAwIDAgMSAyMCAyMiBINCBBMiAyIDAgMCAxIDIgMjAgVjEzIEEyIDIgMCAwIDEgNCAxMSBaIiBmaWxsPSJwYXJhbShmaWxsKSIgc3Ryb2tlPSJwYXJhbShvdXRsaW5lKSIgc3Ryb2tlLXdpZHRoPSJwYXJhbShvdXRsaW5lLXdpZHRoKSIvPjwvc3ZnPg=="/>
            <Option name="offset" type="QString" value="0,0"/>
            <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="offset_unit" type="QString" value="MM"/>
            <Option name="outline_color" type="QString" value="255,255,255,255"/>
            <Option name="outline_width" type="QString" value="0.2"/>
            <Option name="outline_width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="outline_width_unit" type="QString" value="MM"/>
            <Option name="parameters"/>
            <Option name="scale_method" type="QString" value="diameter"/>
            <Option name="size" type="QString" value="5"/>
            <Option name="size_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="size_unit" type="QString" value="MM"/>
            <Option name="vertical_anchor_point" type="QString" value="1"/>
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
              <Option name="name" type="QString" value=""/>
              <Option name="properties" type="Map">
                <Option name="angle" type="Map">
                  <Option name="active" type="bool" value="true"/>
                  <Option name="expression" type="QString" value="coalesce(&quot;direction&quot;, 0)"/>
                  <Option name="type" type="int" value="3"/>
                </Option>
              </Option>
              <Option name="type" type="QString" value="collection"/>
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
            <Option name="DocumentViewer" type="int" value="0"/>
            <Option name="FileWidget" type="bool" value="true"/>
            <Option name="FileWidgetButton" type="bool" value="true"/>
            <Option name="FileWidgetFilter" type="QString" value=""/>
            <Option name="FullUrl" type="bool" value="true"/>
            <Option name="RelativeStorage" type="int" value="0"/>
            <Option name="StorageMode" type="int" value="0"/>
            <Option name="UseLink" type="bool" value="true"/>
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
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="1"/>
            <Option name="Step" type="double" value="0.1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="direction" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="1"/>
            <Option name="Step" type="double" value="0.1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
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
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="1"/>
            <Option name="Step" type="double" value="0.1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="hfov" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="1"/>
            <Option name="Step" type="double" value="0.1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="vfov" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="1"/>
            <Option name="Step" type="double" value="0.1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
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
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="1"/>
            <Option name="Step" type="double" value="0.1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
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
            <Option name="DefaultRoot" type="QString" value=""/>
            <Option name="DocumentViewer" type="int" value="1"/>
            <Option name="DocumentViewerHeight" type="int" value="220"/>
            <Option name="DocumentViewerWidth" type="int" value="0"/>
            <Option name="FileWidget" type="bool" value="false"/>
            <Option name="FileWidgetButton" type="bool" value="false"/>
            <Option name="PropertyCollection" type="Map">
              <Option name="name" type="invalid"/>
              <Option name="properties" type="Map">
                <Option name="propertyRootPath" type="Map">
                  <Option name="active" type="bool" value="true"/>
                  <Option name="expression" type="QString" value="file_path(layer_property(@layer, 'path'))"/>
                  <Option name="type" type="int" value="3"/>
                </Option>
              </Option>
              <Option name="type" type="QString" value="collection"/>
            </Option>
            <Option name="RelativeStorage" type="int" value="2"/>
            <Option name="StorageMode" type="int" value="0"/>
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
    <default field="photo" applyOnUpdate="0" expression=""/>
    <default field="filename" applyOnUpdate="0" expression=""/>
    <default field="directory" applyOnUpdate="0" expression=""/>
    <default field="altitude" applyOnUpdate="0" expression=""/>
    <default field="direction" applyOnUpdate="0" expression=""/>
    <default field="rotation" applyOnUpdate="0" expression=""/>
    <default field="longitude" applyOnUpdate="0" expression=""/>
    <default field="latitude" applyOnUpdate="0" expression=""/>
    <default field="timestamp" applyOnUpdate="0" expression=""/>
    <default field="f35" applyOnUpdate="0" expression=""/>
    <default field="hfov" applyOnUpdate="0" expression=""/>
    <default field="vfov" applyOnUpdate="0" expression=""/>
    <default field="width" applyOnUpdate="0" expression=""/>
    <default field="height" applyOnUpdate="0" expression=""/>
    <default field="dir_ref" applyOnUpdate="0" expression=""/>
    <default field="h_acc" applyOnUpdate="0" expression=""/>
    <default field="camera" applyOnUpdate="0" expression=""/>
    <default field="preview" applyOnUpdate="0" expression=""/>
  </defaults>
  <constraints>
    <constraint field="photo" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="filename" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="directory" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="altitude" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="direction" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="rotation" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="longitude" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="latitude" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="timestamp" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="f35" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="hfov" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="vfov" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="width" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="height" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="dir_ref" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="h_acc" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="camera" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="preview" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
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
  <attributetableconfig actionWidgetStyle="dropDown" sortExpression="" sortOrder="0">
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
    <attributeEditorContainer columnCount="1" name="Photo" visibilityExpressionEnabled="0" showLabel="1" groupBox="0" visibilityExpression="">
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
    <attributeEditorContainer columnCount="1" name="Place" visibilityExpressionEnabled="0" showLabel="1" groupBox="0" visibilityExpression="">
      <attributeEditorField name="altitude" showLabel="1" index="3"/>
      <attributeEditorField name="h_acc" showLabel="1" index="15"/>
      <attributeEditorField name="longitude" showLabel="1" index="6"/>
      <attributeEditorField name="latitude" showLabel="1" index="7"/>
    </attributeEditorContainer>
  </attributeEditorForm>
  <editable/>
  <labelOnTop>
    <field labelOnTop="1" name="preview"/>
  </labelOnTop>
  <reuseLastValue/>
  <dataDefinedFieldProperties/>
  <widgets/>
  <previewExpression>file_name("photo")</previewExpression>
  <mapTip>&lt;img src="file:///[% replace(replace(replace(replace(replace(replace(replace(with_variable('beside', file_path(layer_property(@layer, 'path')) || '/' || "preview", if(file_exists(@beside), @beside, coalesce("preview", "photo"))), '\\', '/'), '%', '%25'), '#', '%23'), '?', '%3F'), '&amp;', '&amp;amp;'), '&lt;', '&amp;lt;'), '"', '&amp;quot;') %]" width="320"/>&lt;br/>[% replace(replace(replace(file_name("photo"), '&amp;', '&amp;amp;'), '&lt;', '&amp;lt;'), '"', '&amp;quot;') %] [% coalesce('recorded ' || round("direction", 1) || '°', '') %]</mapTip>
  <layerGeometryType>0</layerGeometryType>
</qgis>
