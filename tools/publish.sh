#!/bin/bash
# Upload a zip as a new version to the QGIS plugin site: tools/publish.sh ZIP
#
# QGIS_PLUGIN_TOKEN is a token of this plugin, which an owner makes on the plugin's page. The first version of all has to be
# uploaded by hand, since there is no page before it. The token reaches curl through its standard input, so that no list of
# processes shows it.
set -euo pipefail
zip=$1
site=${QGIS_PLUGIN_SITE:-https://plugins.qgis.org}
if [ -z "${QGIS_PLUGIN_TOKEN:-}" ]; then
  echo "QGIS_PLUGIN_TOKEN is not set. Make a token at $site/plugins/skyline_viewshed/tokens/ and set it." >&2
  exit 1
fi
printf 'header = "Authorization: Bearer %s"\n' "$QGIS_PLUGIN_TOKEN" |
  curl --config - --silent --show-error --fail-with-body --form "package=@$zip" \
    "$site/plugins/api/skyline_viewshed/version/add/"
echo
