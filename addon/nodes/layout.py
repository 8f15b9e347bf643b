"""Places the nodes of a group so that a person can follow them: data flows to the
right, and every frame (a named term) has a lane of its own."""

__all__ = ["arrange"]

COLUMN = 190.0
ROW = 46.0
LANE_GAP = 70.0
TALL = {"NodeGroupInput": 30.0, "NodeGroupOutput": 30.0}


def arrange(tree, frame_of):
    """Set every node's place, and put nodes of one frame label into a frame.

    frame_of maps node names to frame labels.
    """
    columns = _columns(tree)
    lanes = {}
    for node in tree.nodes:
        lanes.setdefault(frame_of.get(node.name, ""), []).append(node)
    top = 0.0
    for label, nodes in sorted(lanes.items(), key=lambda lane: _mean_column(lane[1], columns)):
        frame = _frame(tree, label) if label else None
        top -= _place(nodes, columns, top, frame) + LANE_GAP


def _columns(tree):
    """How many links lie at most between a node and the group's inputs."""
    before = {node.name: [] for node in tree.nodes}
    for link in tree.links:
        before[link.to_node.name].append(link.from_node.name)
    columns = {}
    for name in before:
        _depth(name, before, columns)
    users = {}
    for name, sources in before.items():
        for source in sources:
            users.setdefault(source, []).append(columns[name])
    for node in tree.nodes:  # inputs stand beside what they feed
        if node.bl_idname == "NodeGroupInput" and node.name in users:
            columns[node.name] = min(users[node.name]) - 1
    return columns


def _depth(name, before, columns):
    if name not in columns:
        columns[name] = 1 + max((_depth(source, before, columns) for source in before[name]), default=-1)
    return columns[name]


def _mean_column(nodes, columns):
    return sum(columns[node.name] for node in nodes) / len(nodes)


def _place(nodes, columns, top, frame):
    """Place one lane's nodes below `top`; return the lane's height."""
    heights = {}
    for node in sorted(nodes, key=lambda node: (columns[node.name], node.name)):
        column = columns[node.name]
        used = heights.get(column, 0.0)
        is_math = node.bl_idname in {"ShaderNodeMath", "ShaderNodeVectorMath", "ShaderNodeMix",
                                     "ShaderNodeCombineXYZ", "ShaderNodeSeparateXYZ"}
        node.hide = is_math
        if frame is not None:
            node.parent = frame
        node.location = (column * COLUMN, top - used)
        if node.bl_idname == "NodeGroupInput":
            for socket in node.outputs:
                socket.hide = not socket.is_linked
        heights[column] = used + (ROW if is_math else _height(node))
    return max(heights.values())


def _height(node):
    shown = sum(not socket.hide for socket in (*node.inputs, *node.outputs))
    return TALL.get(node.bl_idname, 90.0) + 24.0 * shown


def _frame(tree, label):
    frame = tree.nodes.new("NodeFrame")
    frame.label = label
    frame.name = f"Frame {label}"
    frame.label_size = 20
    return frame
