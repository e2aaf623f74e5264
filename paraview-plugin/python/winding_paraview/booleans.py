# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding Number Boolean: union, intersection and difference of solids."""

import contextlib
import ctypes

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

from vtkwinding import _library
from vtkwinding._booleans import reach_of, reaches_beyond
from vtkwinding._errors import WindingError
from vtkwinding._library import sentence

from .algorithm import RUN, copied, declared, legend_of
from .grids import sample_count, whole_extent
from .ranks import Ranks
from .sources import ask_for_part, blocks_with_names, kind_of, named_blocks
from .surfaces import SurfaceAlgorithm

_ANY_OTHER = -1  # operand without a threshold or rule of its own


@declared
class WindingNumberBoolean(SurfaceAlgorithm):
    """The surface of what an operation makes of solids."""

    has_several_sources = True

    def __init__(self):
        super().__init__(ports=2)
        self.names = ({}, {})  # of connections, by port
        self.thresholds, self.rules = {}, {}  # by operand
        self.infos = []
        self.legend = ""
        self._kept = {}  # the field of each operand, and what it was made of

    def FillInputPortInformation(self, port, info):
        info.Set(self.INPUT_IS_REPEATABLE(), 1)
        if port == 1:
            info.Set(self.INPUT_IS_OPTIONAL(), 1)
        return super().FillInputPortInformation(port, info)

    def RequestUpdateExtent(self, request, inputs, outputs):
        for port in inputs:
            for index in range(port.GetNumberOfInformationObjects()):
                ask_for_part(port.GetInformationObject(index), Ranks(),
                             self.values["SourceDistribution"])
        return 1

    def more_properties(self):
        return [sorted(one.items()) for one in (*self.names, self.thresholds, self.rules)]

    def check(self):
        self.legend = ""
        super().check()

    def GetOperandLegend(self):
        return self.legend

    def RemoveOtherConnections(self):
        self.SetInputConnection(1, None)

    def _set(self, choices, key, value):
        if choices.get(key) != value:
            choices[key] = value
            self.Modified()

    def _clear(self, choices):
        if choices:
            choices.clear()
            self.Modified()

    def SetInputName(self, connection, name):
        self._set(self.names[0], connection, name)

    def ClearInputNames(self):
        self._clear(self.names[0])

    def SetOtherName(self, connection, name):
        self._set(self.names[1], connection, name)

    def ClearOtherNames(self):
        self._clear(self.names[1])

    def SetOperandThreshold(self, operand, threshold):
        self._set(self.thresholds, operand, threshold)

    def ClearOperandThresholds(self):
        self._clear(self.thresholds)

    def SetOperandInsideRule(self, operand, rule):
        self._set(self.rules, operand, rule)

    def ClearOperandInsideRules(self):
        self._clear(self.rules)

    def connections(self):
        return [self.GetInputConnection(port, index) for port in (0, 1)
                for index in range(self.GetNumberOfInputConnections(port))]

    def source(self):
        """Returns the operands as blocks with names."""
        found = [(self.GetInputDataObject(port, index), self.names[port].get(index))
                 for port in (0, 1) for index in range(self.GetNumberOfInputConnections(port))]
        if len(found) == 1:
            found = blocks_with_names(found[0][0]) or found
        return named_blocks(found)

    def bounds_of_source(self, data, ranks):
        """Returns the box of what the result can reach, or None."""
        boxes = [super(WindingNumberBoolean, self).bounds_of_source(data.GetBlock(index), ranks)
                 for index in range(data.GetNumberOfBlocks())]
        return reach_of(boxes, self.value("Operation"),
                        [self._reaches_beyond(index) for index in range(len(boxes))])

    def bounds_key(self):
        operands = sorted({_ANY_OTHER, *self.thresholds, *self.rules})
        return (*super().bounds_key(), self.value("Operation"),
                [(operand, self._reaches_beyond(operand)) for operand in operands])

    def _reaches_beyond(self, operand):
        rule = self._rule_of(operand)
        return reaches_beyond(rule.inside_rule, rule.winding_threshold, self.values["SheetSide"])

    def _rule_of(self, operand):
        rule = self.rules.get(operand, self.value("InsideRule"))
        if rule not in (0, 1, 2):
            raise WindingError(f"Inside Rule is {rule}; it must be Signed (0), Absolute (1) or "
                               "Odd (2)")
        return _library.Rule(inside_rule=rule, winding_threshold=self.thresholds.get(
            operand, self.values["WindingThreshold"]))

    @contextlib.contextmanager
    def _naming(self, name):
        """Adds the name of an operand to what is refused, and before warnings."""
        tell = self.warn
        self.warn = lambda text: tell(f"'{name}': {text}")
        try:
            yield
        except WindingError as error:
            error.args = (f"{error}{', ' if '; ' in str(error) else '; '}solid '{name}'",)
            raise
        finally:
            del self.warn

    def _prepare_all(self, data, ranks, *, says):
        """Makes the fields of all operands. Returns these, and the names of operands."""
        count = data.GetNumberOfBlocks()
        if count < 2:
            raise WindingError(sentence("fewerThanTwoSolids"))
        names = [data.GetMetaData(index).Get(vtkCompositeDataSet.NAME()) for index in range(count)]
        fields, self.infos, kept = [], [], {}
        for index, name in enumerate(names):
            # prepare() keeps one field: that of this operand is put in its place.
            self.field_key, self.field, self.field_notes = self._kept.get(index, (None, None, []))
            self.source_kind = kind_of(data.GetBlock(index))
            with self._naming(name), ranks.agreeing():  # so that all are at this operand
                is_own = self.prepare(data.GetBlock(index), ranks, says=says)
            kept[index] = (self.field_key, self.field, self.field_notes)
            fields.append(self.field)
            if is_own:
                self.infos.append(self.info)
        self._kept = kept
        self.source_kind = kind_of(data)
        return fields, names

    def solids(self, data, ranks):
        fields, _ = self._prepare_all(data, ranks, says=False)
        return [(field, self._rule_of(index)) for index, field in enumerate(fields)]

    def make(self, data, ranks, output, image):
        fields, names = self._prepare_all(data, ranks, says=True)
        count = len(fields)
        rules = [self._rule_of(index) for index in range(count)]
        if len(self.infos) < count:
            return False
        self.info = max(self.infos, key=lambda info: info.primitives)
        needed = sum(self.bytes_of_surface(*pair, self.surface_options())
                     for pair in zip(fields, rules))
        self.expect(sample_count(whole_extent(self.grid)), False, needed)
        self._combine(fields, rules, names, output, image)
        self.verification = self.verify_all(fields, self.grid, whole_extent(self.grid))
        return True

    def _combine(self, fields, rules, names, output, image):
        handles = (ctypes.c_void_p * len(fields))(*(one.pointer.value for one in fields))
        both = (_library.Rule * len(rules))(*rules)
        encoded = (ctypes.c_char_p * len(names))(*(name.encode() for name in names))
        options = self.surface_options(names=ctypes.addressof(encoded))
        mesh = _library.Handle("winding_mesh_free")
        self.evaluate("winding_boolean", handles, ctypes.c_size_t(len(fields)),
                      ctypes.c_int32(self.value("Operation")), ctypes.byref(self.grid), both,
                      ctypes.byref(options), RUN, ctypes.byref(mesh.pointer))
        arrays = _library.arrays_of(mesh)
        self.add_mesh(arrays, output, image)
        numbers = [] if arrays["numbers"] is None else arrays["numbers"]
        output.GetCellData().AddArray(copied("Operand", np.asarray(numbers, np.int32)))
        texts = vtkStringArray()
        texts.SetName("OperandNames")
        for name in names:
            texts.InsertNextValue(name)
        output.GetFieldData().AddArray(texts)
        self.legend = legend_of(output.GetFieldData(), None, "OperandNames")
        self.describe(output)
