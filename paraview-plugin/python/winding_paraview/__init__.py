"""The filters and readers of the ParaView plugin in Python."""
