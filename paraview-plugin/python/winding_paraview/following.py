# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the client of ParaView is to do for the plugin: colours of arrays, and reports of filters
that are read again after each execution."""

from vtkmodules.vtkCommonCore import vtkCommand

_COLORS = ".array_lookup_tables.WindingNumber.PVLookupTable"
# ParaView's own defaults have priority 0, settings of the site and of the user 1 and more.
_PRIORITY = 0.5


def start(folder):
    """Does so from now on, unless this process is a server. A second call changes nothing."""
    try:
        from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager, vtkSMSettings
        from paraview.modules.vtkRemotingCore import vtkProcessModule
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


# The filters whose reports are read again, by their numbers.
_followed = set()


def _look(manager, _event):
    """Looks for filters that are not followed yet. ParaView hands Python no word of what is new."""
    session = manager.GetActiveSessionProxyManager()
    for index in range(session.GetNumberOfProxies("sources") if session is not None else 0):
        proxy = session.GetProxy("sources", session.GetProxyName("sources", index))
        is_ours = proxy is not None and "WindingNumber" in (proxy.GetVTKClassName() or "")
        if is_ours and proxy.GetGlobalID() not in _followed:
            _followed.add(proxy.GetGlobalID())
            proxy.AddObserver(vtkCommand.UpdateDataEvent, _read_again)


def _read_again(proxy, _event):
    proxy.UpdatePropertyInformation()
