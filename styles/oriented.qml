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
  <renderer-v2 attr="status" type="categorizedSymbol" forceraster="0" enableorderby="0" symbollevels="0" referencescale="-1">
    <categories>
      <category symbol="0" label="accepted: trust it" render="true" value="accepted"/>
      <category symbol="1" label="ambiguous: look at the report" render="true" value="ambiguous"/>
      <category symbol="2" label="rejected: no answer" render="true" value="rejected"/>
      <category symbol="3" label="failed: input at fault" render="true" value="failed"/>
    </categories>
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
            <Option name="geometryModifier" type="QString" value="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
            <Option name="units" type="QString" value="MM"/>
          </Option>
          <prop k="SymbolType" v="Fill"/>
          <prop k="geometryModifier" v="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
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
                <Option name="color" type="QString" value="31,138,91,70"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="offset" type="QString" value="0,0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="outline_color" type="QString" value="31,138,91,255"/>
                <Option name="outline_style" type="QString" value="solid"/>
                <Option name="outline_width" type="QString" value="0.3"/>
                <Option name="outline_width_unit" type="QString" value="MM"/>
                <Option name="style" type="QString" value="solid"/>
              </Option>
              <prop k="border_width_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="color" v="31,138,91,70"/>
              <prop k="joinstyle" v="bevel"/>
              <prop k="offset" v="0,0"/>
              <prop k="offset_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="offset_unit" v="MM"/>
              <prop k="outline_color" v="31,138,91,255"/>
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
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '31,138,91,70')"/>
                      <Option name="type" type="int" value="3"/>
                    </Option>
                    <Option name="outlineColor" type="Map">
                      <Option name="active" type="bool" value="true"/>
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '31,138,91,255')"/>
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
            <Option name="color" type="QString" value="31,138,91,255"/>
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
          <prop k="color" v="31,138,91,255"/>
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
                  <Option name="expression" type="QString" value="coalesce(&quot;heading&quot;, 0)"/>
                  <Option name="type" type="int" value="3"/>
                </Option>
              </Option>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol name="1" alpha="1" clip_to_extent="1" type="marker" force_rhr="0">
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
            <Option name="geometryModifier" type="QString" value="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
            <Option name="units" type="QString" value="MM"/>
          </Option>
          <prop k="SymbolType" v="Fill"/>
          <prop k="geometryModifier" v="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
          <prop k="units" v="MM"/>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol name="@1@0" alpha="1" clip_to_extent="1" type="fill" force_rhr="0">
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
                <Option name="color" type="QString" value="230,159,0,70"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="offset" type="QString" value="0,0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="outline_color" type="QString" value="230,159,0,255"/>
                <Option name="outline_style" type="QString" value="solid"/>
                <Option name="outline_width" type="QString" value="0.3"/>
                <Option name="outline_width_unit" type="QString" value="MM"/>
                <Option name="style" type="QString" value="solid"/>
              </Option>
              <prop k="border_width_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="color" v="230,159,0,70"/>
              <prop k="joinstyle" v="bevel"/>
              <prop k="offset" v="0,0"/>
              <prop k="offset_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="offset_unit" v="MM"/>
              <prop k="outline_color" v="230,159,0,255"/>
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
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '230,159,0,70')"/>
                      <Option name="type" type="int" value="3"/>
                    </Option>
                    <Option name="outlineColor" type="Map">
                      <Option name="active" type="bool" value="true"/>
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '230,159,0,255')"/>
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
            <Option name="color" type="QString" value="230,159,0,255"/>
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
          <prop k="color" v="230,159,0,255"/>
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
                  <Option name="expression" type="QString" value="coalesce(&quot;heading&quot;, 0)"/>
                  <Option name="type" type="int" value="3"/>
                </Option>
              </Option>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol name="2" alpha="1" clip_to_extent="1" type="marker" force_rhr="0">
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
            <Option name="geometryModifier" type="QString" value="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
            <Option name="units" type="QString" value="MM"/>
          </Option>
          <prop k="SymbolType" v="Fill"/>
          <prop k="geometryModifier" v="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
          <prop k="units" v="MM"/>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol name="@2@0" alpha="1" clip_to_extent="1" type="fill" force_rhr="0">
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
                <Option name="color" type="QString" value="122,127,133,70"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="offset" type="QString" value="0,0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="outline_color" type="QString" value="122,127,133,255"/>
                <Option name="outline_style" type="QString" value="solid"/>
                <Option name="outline_width" type="QString" value="0.3"/>
                <Option name="outline_width_unit" type="QString" value="MM"/>
                <Option name="style" type="QString" value="solid"/>
              </Option>
              <prop k="border_width_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="color" v="122,127,133,70"/>
              <prop k="joinstyle" v="bevel"/>
              <prop k="offset" v="0,0"/>
              <prop k="offset_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="offset_unit" v="MM"/>
              <prop k="outline_color" v="122,127,133,255"/>
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
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '122,127,133,70')"/>
                      <Option name="type" type="int" value="3"/>
                    </Option>
                    <Option name="outlineColor" type="Map">
                      <Option name="active" type="bool" value="true"/>
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '122,127,133,255')"/>
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
            <Option name="color" type="QString" value="122,127,133,255"/>
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
          <prop k="color" v="122,127,133,255"/>
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
                  <Option name="expression" type="QString" value="coalesce(&quot;heading&quot;, 0)"/>
                  <Option name="type" type="int" value="3"/>
                </Option>
              </Option>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol name="3" alpha="1" clip_to_extent="1" type="marker" force_rhr="0">
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
            <Option name="geometryModifier" type="QString" value="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
            <Option name="units" type="QString" value="MM"/>
          </Option>
          <prop k="SymbolType" v="Fill"/>
          <prop k="geometryModifier" v="if(&quot;heading&quot; is null, null, wedge_buffer(centroid($geometry), 180 - &quot;heading&quot;, min(coalesce(&quot;hfov&quot;, 60), 359), 11))"/>
          <prop k="units" v="MM"/>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol name="@3@0" alpha="1" clip_to_extent="1" type="fill" force_rhr="0">
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
                <Option name="color" type="QString" value="192,57,43,70"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="offset" type="QString" value="0,0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="outline_color" type="QString" value="192,57,43,255"/>
                <Option name="outline_style" type="QString" value="solid"/>
                <Option name="outline_width" type="QString" value="0.3"/>
                <Option name="outline_width_unit" type="QString" value="MM"/>
                <Option name="style" type="QString" value="solid"/>
              </Option>
              <prop k="border_width_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="color" v="192,57,43,70"/>
              <prop k="joinstyle" v="bevel"/>
              <prop k="offset" v="0,0"/>
              <prop k="offset_map_unit_scale" v="3x:0,0,0,0,0,0"/>
              <prop k="offset_unit" v="MM"/>
              <prop k="outline_color" v="192,57,43,255"/>
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
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '192,57,43,70')"/>
                      <Option name="type" type="int" value="3"/>
                    </Option>
                    <Option name="outlineColor" type="Map">
                      <Option name="active" type="bool" value="true"/>
                      <Option name="expression" type="QString" value="if($id is null, '0,0,0,0', '192,57,43,255')"/>
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
            <Option name="color" type="QString" value="192,57,43,255"/>
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
          <prop k="color" v="192,57,43,255"/>
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
                  <Option name="expression" type="QString" value="coalesce(&quot;heading&quot;, 0)"/>
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
    <field name="heading" configurationFlags="None">
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
    <field name="pitch" configurationFlags="None">
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
    <field name="roll" configurationFlags="None">
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
    <field name="ncc" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="2"/>
            <Option name="Step" type="double" value="0.01"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="ncc_2nd" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="2"/>
            <Option name="Step" type="double" value="0.01"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="heading_2" configurationFlags="None">
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
    <field name="heading_3" configurationFlags="None">
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
    <field name="sharpness" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="2"/>
            <Option name="Step" type="double" value="0.01"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="heading_lo" configurationFlags="None">
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
    <field name="heading_hi" configurationFlags="None">
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
    <field name="p_correct" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="2"/>
            <Option name="Step" type="double" value="0.01"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="status" configurationFlags="None">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="message" configurationFlags="None">
      <editWidget type="TextEdit">
        <config>
          <Option type="Map">
            <Option name="IsMultiline" type="bool" value="true"/>
            <Option name="UseHtml" type="bool" value="false"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="compass" configurationFlags="None">
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
    <field name="compass_df" configurationFlags="None">
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
    <field name="grid_conv" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="2"/>
            <Option name="Step" type="double" value="0.01"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="horizon_m" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="0"/>
            <Option name="Step" type="double" value="1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="eye_z" configurationFlags="None">
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
    <field name="observ_hgt" configurationFlags="None">
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
    <field name="radius" configurationFlags="None">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Max" type="double" value="1e+09"/>
            <Option name="Min" type="double" value="-1e+09"/>
            <Option name="Precision" type="int" value="0"/>
            <Option name="Step" type="double" value="1"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="azim_1" configurationFlags="None">
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
    <field name="azim_2" configurationFlags="None">
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
    <alias name="Heading (° from true north)" field="heading" index="17"/>
    <alias name="Pitch (°, + up)" field="pitch" index="18"/>
    <alias name="Roll (°, + right side down)" field="roll" index="19"/>
    <alias name="Correlation of skylines" field="ncc" index="20"/>
    <alias name="Correlation of the second-best heading" field="ncc_2nd" index="21"/>
    <alias name="Second-best heading (°)" field="heading_2" index="22"/>
    <alias name="Third-best heading (°)" field="heading_3" index="23"/>
    <alias name="Sharpness of the correlation peak" field="sharpness" index="24"/>
    <alias name="Heading, lower end of the 90 % interval (°)" field="heading_lo" index="25"/>
    <alias name="Heading, upper end of the 90 % interval (°)" field="heading_hi" index="26"/>
    <alias name="Probability that the heading is right within 3°" field="p_correct" index="27"/>
    <alias name="Status" field="status" index="28"/>
    <alias name="Message" field="message" index="29"/>
    <alias name="Recorded heading (° from true north)" field="compass" index="30"/>
    <alias name="Recorded minus found heading (°)" field="compass_df" index="31"/>
    <alias name="Grid convergence of the DEM (°)" field="grid_conv" index="32"/>
    <alias name="Distance of the horizon at the heading (m)" field="horizon_m" index="33"/>
    <alias name="Elevation of the camera (m)" field="eye_z" index="34"/>
    <alias name="Camera above the DEM (m), for Visibility Analysis" field="observ_hgt" index="35"/>
    <alias name="Search range (m), for Visibility Analysis" field="radius" index="36"/>
    <alias name="Left edge of view (° from grid north), for Visibility Analysis" field="azim_1" index="37"/>
    <alias name="Right edge of view (° from grid north), for Visibility Analysis" field="azim_2" index="38"/>
    <alias name="Picture" field="preview" index="39"/>
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
    <default field="heading" applyOnUpdate="0" expression=""/>
    <default field="pitch" applyOnUpdate="0" expression=""/>
    <default field="roll" applyOnUpdate="0" expression=""/>
    <default field="ncc" applyOnUpdate="0" expression=""/>
    <default field="ncc_2nd" applyOnUpdate="0" expression=""/>
    <default field="heading_2" applyOnUpdate="0" expression=""/>
    <default field="heading_3" applyOnUpdate="0" expression=""/>
    <default field="sharpness" applyOnUpdate="0" expression=""/>
    <default field="heading_lo" applyOnUpdate="0" expression=""/>
    <default field="heading_hi" applyOnUpdate="0" expression=""/>
    <default field="p_correct" applyOnUpdate="0" expression=""/>
    <default field="status" applyOnUpdate="0" expression=""/>
    <default field="message" applyOnUpdate="0" expression=""/>
    <default field="compass" applyOnUpdate="0" expression=""/>
    <default field="compass_df" applyOnUpdate="0" expression=""/>
    <default field="grid_conv" applyOnUpdate="0" expression=""/>
    <default field="horizon_m" applyOnUpdate="0" expression=""/>
    <default field="eye_z" applyOnUpdate="0" expression=""/>
    <default field="observ_hgt" applyOnUpdate="0" expression=""/>
    <default field="radius" applyOnUpdate="0" expression=""/>
    <default field="azim_1" applyOnUpdate="0" expression=""/>
    <default field="azim_2" applyOnUpdate="0" expression=""/>
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
    <constraint field="heading" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="pitch" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="roll" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="ncc" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="ncc_2nd" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="heading_2" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="heading_3" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="sharpness" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="heading_lo" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="heading_hi" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="p_correct" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="status" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="message" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="compass" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="compass_df" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="grid_conv" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="horizon_m" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="eye_z" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="observ_hgt" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="radius" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="azim_1" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
    <constraint field="azim_2" unique_strength="0" exp_strength="0" constraints="0" notnull_strength="0"/>
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
    <constraint desc="" field="heading" exp=""/>
    <constraint desc="" field="pitch" exp=""/>
    <constraint desc="" field="roll" exp=""/>
    <constraint desc="" field="ncc" exp=""/>
    <constraint desc="" field="ncc_2nd" exp=""/>
    <constraint desc="" field="heading_2" exp=""/>
    <constraint desc="" field="heading_3" exp=""/>
    <constraint desc="" field="sharpness" exp=""/>
    <constraint desc="" field="heading_lo" exp=""/>
    <constraint desc="" field="heading_hi" exp=""/>
    <constraint desc="" field="p_correct" exp=""/>
    <constraint desc="" field="status" exp=""/>
    <constraint desc="" field="message" exp=""/>
    <constraint desc="" field="compass" exp=""/>
    <constraint desc="" field="compass_df" exp=""/>
    <constraint desc="" field="grid_conv" exp=""/>
    <constraint desc="" field="horizon_m" exp=""/>
    <constraint desc="" field="eye_z" exp=""/>
    <constraint desc="" field="observ_hgt" exp=""/>
    <constraint desc="" field="radius" exp=""/>
    <constraint desc="" field="azim_1" exp=""/>
    <constraint desc="" field="azim_2" exp=""/>
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
    <attributeEditorContainer columnCount="1" name="Answer" visibilityExpressionEnabled="0" showLabel="1" groupBox="0" visibilityExpression="">
      <attributeEditorField name="preview" showLabel="1" index="39"/>
      <attributeEditorField name="status" showLabel="1" index="28"/>
      <attributeEditorField name="heading" showLabel="1" index="17"/>
      <attributeEditorField name="heading_lo" showLabel="1" index="25"/>
      <attributeEditorField name="heading_hi" showLabel="1" index="26"/>
      <attributeEditorField name="p_correct" showLabel="1" index="27"/>
      <attributeEditorField name="message" showLabel="1" index="29"/>
    </attributeEditorContainer>
    <attributeEditorContainer columnCount="1" name="Match" visibilityExpressionEnabled="0" showLabel="1" groupBox="0" visibilityExpression="">
      <attributeEditorField name="pitch" showLabel="1" index="18"/>
      <attributeEditorField name="roll" showLabel="1" index="19"/>
      <attributeEditorField name="hfov" showLabel="1" index="10"/>
      <attributeEditorField name="vfov" showLabel="1" index="11"/>
      <attributeEditorField name="heading_2" showLabel="1" index="22"/>
      <attributeEditorField name="heading_3" showLabel="1" index="23"/>
      <attributeEditorField name="compass" showLabel="1" index="30"/>
      <attributeEditorField name="compass_df" showLabel="1" index="31"/>
      <attributeEditorField name="ncc" showLabel="1" index="20"/>
      <attributeEditorField name="ncc_2nd" showLabel="1" index="21"/>
      <attributeEditorField name="sharpness" showLabel="1" index="24"/>
      <attributeEditorField name="horizon_m" showLabel="1" index="33"/>
    </attributeEditorContainer>
    <attributeEditorContainer columnCount="1" name="Place" visibilityExpressionEnabled="0" showLabel="1" groupBox="0" visibilityExpression="">
      <attributeEditorField name="eye_z" showLabel="1" index="34"/>
      <attributeEditorField name="altitude" showLabel="1" index="3"/>
      <attributeEditorField name="h_acc" showLabel="1" index="15"/>
      <attributeEditorField name="longitude" showLabel="1" index="6"/>
      <attributeEditorField name="latitude" showLabel="1" index="7"/>
      <attributeEditorField name="observ_hgt" showLabel="1" index="35"/>
      <attributeEditorField name="radius" showLabel="1" index="36"/>
      <attributeEditorField name="azim_1" showLabel="1" index="37"/>
      <attributeEditorField name="azim_2" showLabel="1" index="38"/>
      <attributeEditorField name="grid_conv" showLabel="1" index="32"/>
    </attributeEditorContainer>
    <attributeEditorContainer columnCount="1" name="Photo" visibilityExpressionEnabled="0" showLabel="1" groupBox="0" visibilityExpression="">
      <attributeEditorField name="photo" showLabel="1" index="0"/>
      <attributeEditorField name="filename" showLabel="1" index="1"/>
      <attributeEditorField name="directory" showLabel="1" index="2"/>
      <attributeEditorField name="timestamp" showLabel="1" index="8"/>
      <attributeEditorField name="camera" showLabel="1" index="16"/>
      <attributeEditorField name="f35" showLabel="1" index="9"/>
      <attributeEditorField name="width" showLabel="1" index="12"/>
      <attributeEditorField name="height" showLabel="1" index="13"/>
      <attributeEditorField name="rotation" showLabel="1" index="5"/>
      <attributeEditorField name="direction" showLabel="1" index="4"/>
      <attributeEditorField name="dir_ref" showLabel="1" index="14"/>
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
  <mapTip>&lt;img src="file:///[% replace(replace(replace(replace(replace(replace(replace(with_variable('beside', file_path(layer_property(@layer, 'path')) || '/' || "preview", if(file_exists(@beside), @beside, coalesce("preview", "photo"))), '\\', '/'), '%', '%25'), '#', '%23'), '?', '%3F'), '&amp;', '&amp;amp;'), '&lt;', '&amp;lt;'), '"', '&amp;quot;') %]" width="320"/>&lt;br/>[% replace(replace(replace(file_name("photo"), '&amp;', '&amp;amp;'), '&lt;', '&amp;lt;'), '"', '&amp;quot;') %] &lt;b>[% coalesce(round("heading", 1) || '°', 'no heading') %]&lt;/b> [% "status" %]&lt;br/>[% replace(replace(replace("message", '&amp;', '&amp;amp;'), '&lt;', '&amp;lt;'), '"', '&amp;quot;') %]</mapTip>
  <layerGeometryType>0</layerGeometryType>
</qgis>
