#include "ColorDefaults.h"

#include "vtkSMSettings.h"

namespace winding
{

void setColorDefaults()
{
  constexpr const char* name = ".array_lookup_tables.WindingNumber.PVLookupTable";
  // ParaView's own defaults have priority 0, settings of the site and of the user 1 and more.
  constexpr double priority = 0.5;
  // The mode −1 is never, the colour space 3 diverging; the colours are those of Cool to Warm.
  constexpr const char* colors = R"({
    "array_lookup_tables": { "WindingNumber": { "PVLookupTable": {
      "AutomaticRescaleRangeMode": -1,
      "UseAboveRangeColor": 1,
      "AboveRangeColor": [ 0.95, 0.6, 0.1 ],
      "UseBelowRangeColor": 1,
      "BelowRangeColor": [ 0.1, 0.65, 0.6 ],
      "ColorSpace": 3,
      "RGBPoints": [ -0.25, 0.231373, 0.298039, 0.752941,
                     0.0, 0.231373, 0.298039, 0.752941,
                     0.5, 0.865003, 0.865003, 0.865003,
                     1.0, 0.705882, 0.0156863, 0.14902,
                     1.25, 0.705882, 0.0156863, 0.14902 ],
      "ScalarRangeInitialized": 1
    } },
    "SignedDistance": { "PVLookupTable": {
      "AutomaticRescaleRangeMode": -1,
      "ColorSpace": 3,
      "RGBPoints": [ -1.0, 0.705882, 0.0156863, 0.14902,
                     0.0, 0.865003, 0.865003, 0.865003,
                     1.0, 0.231373, 0.298039, 0.752941 ],
      "ScalarRangeInitialized": 1
    } },
    "FaultKind": { "PVLookupTable": {
      "IndexedLookup": 1,
      "Annotations": [ "0", "caps", "1", "uncancelled edges",
                       "2", "non-manifold edges", "3", "inconsistent edges" ],
      "IndexedColors": [ 1.0, 0.85, 0.4, 0.8, 0.1, 0.1, 0.1, 0.6, 0.2, 0.15, 0.35, 0.9 ],
      "IndexedOpacities": [ 1.0, 1.0, 1.0, 1.0 ]
    } } }
  })";
  vtkSMSettings* const settings = vtkSMSettings::GetInstance();
  if (!settings->HasSetting(name))
  {
    settings->AddCollectionFromString(colors, priority);
  }
}

} // namespace winding
