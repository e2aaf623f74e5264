# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the client of ParaView is to do for the plugin: colours of arrays, and what follows each new
result of its filters, as FollowResults.h of the plugin in C++ says."""

import math

from vtkmodules.vtkCommonCore import vtkCommand

_COLORS = ".array_lookup_tables.WindingNumber.PVLookupTable"
# ParaView's own defaults have priority 0, settings of the site and of the user 1 and more.
_PRIORITY = 0.5
# Arrays of categories: the property with their names, and whether 0 is outside.
_CATEGORIES = {"Label": ("LabelLegend", True), "Operand": ("OperandLegend", False)}
# The 20 colours are Tableau's, the light ones last.
_PALETTE = ((0.122, 0.467, 0.706), (1, 0.498, 0.055), (0.173, 0.627, 0.173), (0.839, 0.153, 0.157),
            (0.58, 0.404, 0.741), (0.549, 0.337, 0.294), (0.89, 0.467, 0.761),
            (0.498, 0.498, 0.498), (0.737, 0.741, 0.133), (0.09, 0.745, 0.812),
            (0.682, 0.78, 0.91), (1, 0.733, 0.471), (0.596, 0.875, 0.541), (1, 0.596, 0.588),
            (0.773, 0.69, 0.835), (0.769, 0.612, 0.58), (0.969, 0.714, 0.824),
            (0.78, 0.78, 0.78), (0.859, 0.859, 0.553), (0.62, 0.855, 0.898))


def start(folder):
    """Does so from now on, unless this process is a server. A second call changes nothing."""
    try:
        from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager, vtkSMSettings
        from paraview.modules.vtkRemotingCore import vtkProcessModule
        # Without it a window hands Python its views as proxies of no kind.
        import paraview.modules.vtkRemotingViews  # noqa: F401
    except ImportError:
        return  # servers may have none of these
    servers = (vtkProcessModule.PROCESS_SERVER, vtkProcessModule.PROCESS_DATA_SERVER,
               vtkProcessModule.PROCESS_RENDER_SERVER)
    if vtkProcessModule.GetProcessType() in servers:
        return
    settings = vtkSMSettings.GetInstance()
    if not settings.HasSetting(_COLORS):
        text = (folder / "xml" / "ColorDefaults.inc").read_text(encoding="utf-8")
        settings.AddCollectionFromString(text[text.index("{"):text.rindex("}") + 1], _PRIORITY)
    manager = vtkSMProxyManager.GetProxyManager()
    if manager is not None and not _followed:
        _followed.add(0)  # which no proxy has
        manager.AddObserver(vtkCommand.RegisterEvent, _look)


# The proxies that are observed, by their numbers; the extents of images, by their filters; changes
# of representations that wait for the end of an update, which they would break.
_followed, _extents, _changes = set(), {}, []
_failed = set()  # filters whose last image had no samples
# The slices of representations that are outlines instead, and how far distances reach by colours.
_outlined, _reach = {}, [1.0]
# The representations that have been given a map of colours of their own, and the words of maps.
_separated, _named = set(), {}


def _look(manager, _event):
    """Looks for filters and views that are not followed yet. ParaView hands Python no word of what
    is new."""
    session = manager.GetActiveSessionProxyManager()
    for group, follow in (("sources", _follow), ("views", _finish)):
        for index in range(session.GetNumberOfProxies(group) if session is not None else 0):
            proxy = session.GetProxy(group, session.GetProxyName(group, index))
            if (proxy is not None and (group == "views" or _is_of_plugin(proxy))
                    and proxy.GetGlobalID() not in _followed):
                _followed.add(proxy.GetGlobalID())
                proxy.AddObserver(vtkCommand.UpdateDataEvent, follow)


def _is_of_plugin(proxy):
    return proxy is not None and "WindingNumber" in (proxy.GetVTKClassName() or "")


def _follow(source, _event):
    """Follows a new result of a filter."""
    source.UpdatePropertyInformation()
    if source.GetNumberOfOutputPorts() == 0:
        return
    information = source.GetDataInformation(0)
    extent = tuple(information.GetExtent())
    layers = [extent[axis + 1] - extent[axis] + 1 for axis in (0, 2, 4)]
    has_samples = information.GetNumberOfPoints() > 0 and min(layers) > 0
    scalars = information.GetPointDataInformation().GetAttributeInformation(0)
    number = source.GetGlobalID()
    for index in range(source.GetNumberOfConsumers()):
        consumer = source.GetConsumerProxy(index)
        if consumer is not None and consumer.GetProperty("Slice") and consumer.GetProperty(
                "Representation"):
            _follow_slice(consumer, _extents.get(number), extent if has_samples else None,
                          scalars.GetName() if scalars and number in _failed else None)
    _extents[number] = extent if has_samples else _extents.get(number)
    (_failed.discard if has_samples else _failed.add)(number)
    _follow_distances(source, information)
    for array, (legend, has_outside) in _CATEGORIES.items():
        names = source.GetProperty(legend)
        if names is not None:  # of the maps that scripts find by the names of arrays
            _name_categories(_colors_of(source, array), names, has_outside)


def _colors_of(source, array):
    from paraview.modules.vtkRemotingViews import vtkSMTransferFunctionManager

    return vtkSMTransferFunctionManager().GetColorTransferFunction(
        array, source.GetSessionProxyManager())


def _follow_slice(representation, before, extent, scalars):
    """Keeps a slice where it is in the bounds, and shows an image without samples as its outline:
    a slice of nothing would be an error at each render. `scalars` is the active array of the first
    result after some without samples, or None."""
    number = representation.GetGlobalID()
    is_slice = representation.GetProperty("Representation").GetElement(0) == "Slice"
    present = representation.GetProperty("Slice").GetElement(0)
    if extent is None:
        if is_slice:
            _outlined[number] = present
            _changes.append((representation, "Representation", "Outline"))
        return
    is_first, has_moved = before is None and scalars is not None, before != extent
    # ParaView has set the slice to the first layer meanwhile.
    if number in _outlined:
        present, has_moved = _outlined.pop(number), True
        _changes.append((representation, "Representation", "Slice"))
    if is_first:
        # It has found nothing to colour by either.
        _changes.append((representation, "Representation", "Slice"))
        _changes.append((representation, None, scalars))
    if not has_moved or (before is None and not is_first):
        return
    planes = (4, 0, 2)  # first places in extents, for XY, YZ and XZ
    xy_plane = 5
    mode = representation.GetProperty("SliceMode").GetElement(0)
    first = planes[min(max(mode - xy_plane, 0), 2)]
    share = 0.5 if before is None else (
        (present - before[first] + 0.5) / (before[first + 1] - before[first] + 1))
    moved = extent[first] + math.floor(share * (extent[first + 1] - extent[first] + 1))
    _changes.append((representation, "Slice", min(max(moved, extent[first]), extent[first + 1])))


def _follow_distances(source, information):
    """Spreads the colours of signed distances evenly around 0, unless their range was changed."""
    from paraview.modules.vtkRemotingViews import vtkSMTransferFunctionProxy

    name = "SignedDistance"
    array = (information.GetPointDataInformation().GetArrayInformation(name)
             or information.GetCellDataInformation().GetArrayInformation(name))
    if array is None:
        return
    ends = [0.0, 0.0]
    array.GetComponentFiniteRange(0, ends)
    reach = max(map(abs, ends))
    colors = _colors_of(source, name)
    present = [0.0, 0.0]
    is_own = (colors is not None and vtkSMTransferFunctionProxy.GetRange(colors, present)
              and present[1] == _reach[0])
    if is_own and 0 < reach != _reach[0]:
        vtkSMTransferFunctionProxy.RescaleTransferFunction(colors, -reach, reach, False)
        _reach[0] = reach


def _finish(view, _event):
    """Makes the changes that wait, and names the categories of what a view shows."""
    changes, _changes[:] = _changes[:], []
    for representation, name, value in changes:
        if name is None:
            representation.SetScalarColoring(value, 0)
            continue
        representation.GetProperty(name).SetElement(0, value)
        representation.UpdateVTKObjects()
    if changes:
        view.Update()
    shown = view.GetProperty("Representations")
    for index in range(shown.GetNumberOfProxies() if shown else 0):
        _follow_categories(shown.GetProxy(index), view)


def _follow_categories(representation, view):
    """Gives a result with categories a map of colours of its own, with their names."""
    array, source = (representation.GetProperty(name) for name in ("ColorArrayName", "Input"))
    if not array or not source or not source.GetNumberOfProxies():
        return
    legend, has_outside = _CATEGORIES.get(array.GetElement(4), (None, False))
    source = source.GetProxy(0)
    names = source.GetProperty(legend) if legend and _is_of_plugin(source) else None
    if names is None or not names.GetElement(0):
        return
    number = representation.GetGlobalID()
    if number not in _separated:
        _separated.add(number)
        _separate(representation, view, array)
    colors = representation.GetProperty("LookupTable").GetProxy(0)
    if colors is not None:
        _name_categories(colors, names, has_outside)


def _separate(representation, view, array):
    """Gives a representation a map of its own, which its user may give up again."""
    from paraview.modules.vtkRemotingViews import vtkSMTransferFunctionManager

    has_bar = representation.IsScalarBarVisible(view)
    representation.GetProperty("UseSeparateColorMap").SetElement(0, 1)
    representation.SetScalarColoring(array.GetElement(4), int(array.GetElement(3)))
    if has_bar:
        representation.SetScalarBarVisibility(view, True)
    vtkSMTransferFunctionManager().UpdateScalarBars(
        view, vtkSMTransferFunctionManager.HIDE_UNUSED_SCALAR_BARS)


def _name_categories(colors, names, has_outside):
    """Gives categories a colour each, and their names, unless a map has been given these before.
    So what its user changes stays."""
    lines = [line.split("\t", 1) for line in (names.GetElement(0) or "").splitlines()]
    outside = [["0", "outside"]] if has_outside else []
    words = [text for line in outside + lines for text in line]
    if not lines or _named.get(colors.GetGlobalID()) == words:
        return
    _named[colors.GetGlobalID()] = words
    rgb = [part for line in outside for part in (0.93, 0.93, 0.93)]
    for number in range(1, len(lines) + 1):
        rgb += _PALETTE[number % len(_PALETTE)]
    opacities = [0.0] * len(outside) + [1.0] * len(lines)
    for name, values in (("Annotations", words), ("IndexedLookup", [1]), ("IndexedColors", rgb),
                         ("IndexedOpacities", opacities), ("EnableOpacityMapping", [1])):
        found = colors.GetProperty(name)
        found.SetNumberOfElements(len(values))
        for index, value in enumerate(values):
            found.SetElement(index, value)
    colors.UpdateVTKObjects()
