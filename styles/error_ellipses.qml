<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis labelsEnabled="0" simplifyDrawingHints="1" simplifyDrawingTol="1" maxScale="0" simplifyLocal="1" simplifyMaxScale="1" readOnly="0" hasScaleBasedVisibilityFlag="0" minScale="100000000" version="3.22.16-Białowieża" styleCategories="AllStyleCategories" simplifyAlgorithm="0" symbologyReferenceScale="-1">
  <flags>
    <Identifiable>1</Identifiable>
    <Removable>1</Removable>
    <Searchable>1</Searchable>
    <Private>0</Private>
  </flags>
  <temporal endExpression="" startField="" fixedDuration="0" durationField="" mode="0" endField="" enabled="0" durationUnit="min" limitMode="0" startExpression="" accumulate="0">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <renderer-v2 symbollevels="0" enableorderby="0" referencescale="-1" forceraster="0" type="singleSymbol">
    <symbols>
      <symbol force_rhr="0" name="0" clip_to_extent="1" alpha="1" type="fill">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" value="" type="QString"/>
            <Option name="properties"/>
            <Option name="type" value="collection" type="QString"/>
          </Option>
        </data_defined_properties>
        <layer locked="0" class="SimpleFill" enabled="1" pass="0">
          <Option type="Map">
            <Option name="border_width_map_unit_scale" value="3x:0,0,0,0,0,0" type="QString"/>
            <Option name="color" value="242,177,52,45" type="QString"/>
            <Option name="joinstyle" value="bevel" type="QString"/>
            <Option name="offset" value="0,0" type="QString"/>
            <Option name="offset_map_unit_scale" value="3x:0,0,0,0,0,0" type="QString"/>
            <Option name="offset_unit" value="MM" type="QString"/>
            <Option name="outline_color" value="176,122,0,255" type="QString"/>
            <Option name="outline_style" value="dash" type="QString"/>
            <Option name="outline_width" value="0.3" type="QString"/>
            <Option name="outline_width_unit" value="MM" type="QString"/>
            <Option name="style" value="solid" type="QString"/>
          </Option>
          <prop k="border_width_map_unit_scale" v="3x:0,0,0,0,0,0"/>
          <prop k="color" v="242,177,52,45"/>
          <prop k="joinstyle" v="bevel"/>
          <prop k="offset" v="0,0"/>
          <prop k="offset_map_unit_scale" v="3x:0,0,0,0,0,0"/>
          <prop k="offset_unit" v="MM"/>
          <prop k="outline_color" v="176,122,0,255"/>
          <prop k="outline_style" v="dash"/>
          <prop k="outline_width" v="0.3"/>
          <prop k="outline_width_unit" v="MM"/>
          <prop k="style" v="solid"/>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" value="" type="QString"/>
              <Option name="properties"/>
              <Option name="type" value="collection" type="QString"/>
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
  <geometryOptions removeDuplicateNodes="0" geometryPrecision="0">
    <activeChecks type="StringList">
      <Option value="" type="QString"/>
    </activeChecks>
    <checkConfiguration/>
  </geometryOptions>
  <legend showLabelLegend="0" type="default-vector"/>
  <referencedLayers/>
  <fieldConfiguration>
    <field configurationFlags="None" name="photo">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="label">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="coverage">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="err_major">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="err_minor">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="err_azim">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="err_z">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="p_other">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="near_m">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="None" name="far_m">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
  </fieldConfiguration>
  <aliases>
    <alias name="Photo" index="0" field="photo"/>
    <alias name="Label" index="1" field="label"/>
    <alias name="Probability that the ellipse contains the true position" index="2" field="coverage"/>
    <alias name="Error ellipse, major half axis (m)" index="3" field="err_major"/>
    <alias name="Error ellipse, minor half axis (m)" index="4" field="err_minor"/>
    <alias name="Direction of the major axis (° from true north)" index="5" field="err_azim"/>
    <alias name="Standard deviation of the elevation (m)" index="6" field="err_z"/>
    <alias name="Probability that the pixel shows other ground, beyond an edge" index="7" field="p_other"/>
    <alias name="Distance, 5 % quantile (m)" index="8" field="near_m"/>
    <alias name="Distance, 95 % quantile (m)" index="9" field="far_m"/>
  </aliases>
  <defaults>
    <default expression="" field="photo" applyOnUpdate="0"/>
    <default expression="" field="label" applyOnUpdate="0"/>
    <default expression="" field="coverage" applyOnUpdate="0"/>
    <default expression="" field="err_major" applyOnUpdate="0"/>
    <default expression="" field="err_minor" applyOnUpdate="0"/>
    <default expression="" field="err_azim" applyOnUpdate="0"/>
    <default expression="" field="err_z" applyOnUpdate="0"/>
    <default expression="" field="p_other" applyOnUpdate="0"/>
    <default expression="" field="near_m" applyOnUpdate="0"/>
    <default expression="" field="far_m" applyOnUpdate="0"/>
  </defaults>
  <constraints>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="photo"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="label"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="coverage"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="err_major"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="err_minor"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="err_azim"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="err_z"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="p_other"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="near_m"/>
    <constraint notnull_strength="0" constraints="0" unique_strength="0" exp_strength="0" field="far_m"/>
  </constraints>
  <constraintExpressions>
    <constraint exp="" field="photo" desc=""/>
    <constraint exp="" field="label" desc=""/>
    <constraint exp="" field="coverage" desc=""/>
    <constraint exp="" field="err_major" desc=""/>
    <constraint exp="" field="err_minor" desc=""/>
    <constraint exp="" field="err_azim" desc=""/>
    <constraint exp="" field="err_z" desc=""/>
    <constraint exp="" field="p_other" desc=""/>
    <constraint exp="" field="near_m" desc=""/>
    <constraint exp="" field="far_m" desc=""/>
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
  <editorlayout>generatedlayout</editorlayout>
  <editable/>
  <labelOnTop/>
  <reuseLastValue/>
  <dataDefinedFieldProperties/>
  <widgets/>
  <previewExpression></previewExpression>
  <mapTip></mapTip>
  <layerGeometryType>2</layerGeometryType>
</qgis>
