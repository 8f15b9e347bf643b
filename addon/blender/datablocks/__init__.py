"""Our datablocks in the open file: node groups, materials, ramps."""
