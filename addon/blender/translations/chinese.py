"""The interface's texts in Simplified Chinese."""

__all__ = ["TEXTS"]

TEXTS = {
    "   (Esc stops)":
        "   （按 Esc 停止）",
    " or ":
        " 或 ",
    ". Saved among your presets as {:s}":
        "。已存入自己的预设：{:s}",
    "0° to 90°":
        "0° 至 90°",
    "; ends held":
        "；两端保持不变",
    "; outside the gamut, mapped by {:s}":
        "；超出色域，映射方式：{:s}",
    "; the marks of the finish stay in Blender, its roughness is in it":
        "；表面处理的痕迹留在 Blender 中，其粗糙度已包含",
    "A Fresnel curve is angles from 0° to 90° with three reflectances from 0 to 1 each, such as 'Fresnel 0° 0.1 0.1 0.1 / 90° 1 1 1', not {value!r}.":
        "菲涅耳曲线由 0° 到 90° 的角度及各自的三个 0 到 1 的反射率组成，例如 'Fresnel 0° 0.1 0.1 0.1 / 90° 1 1 1'，而不是 {value!r}。",
    "A button in the headers of the 3D Viewport and of the Shader Editor":
        "3D 视图和着色器编辑器标题栏中的按钮",
    "A check takes one of: n with k, F0 with or without a tint, a material.":
        "检查只接受其中之一：n 与 k、带或不带色调的 F0、一种材质。",
    "A conductor's, by its complex refractive index":
        "导体的反射，由复折射率给出",
    "A dielectric's, by its reflectance at normal incidence":
        "电介质的反射，由垂直入射反射率给出",
    "A file to write is named by its path, not by {path!r}.":
        "要写入的文件须以路径指定，而不是 {path!r}。",
    "A finish is called by its name, such as 'brushed', not {value!r}.":
        "表面处理以名称称呼，例如 'brushed'，而不是 {value!r}。",
    "A finish varies the roughness, which {model} has not: name a material of another model, or no finish.":
        "表面处理改变粗糙度，而 {model} 没有粗糙度：请选择其他模型的材质，或不用表面处理。",
    "A material is a preset's name or a dataset's id, not {value!r}.":
        "材质须为预设名称或数据集标识，而不是 {value!r}。",
    "A metal's color towards the edge is lost there.":
        "金属边缘处的颜色在该格式中会丢失。",
    "A perfect reflector is neutral in any light, as for an eye that is used to it":
        "理想反射体在任何光下都呈中性，如同已适应该光的眼睛",
    "A preset and {name} both say what the material is made of: give one of them.":
        "预设和 {name} 都说明了材质的组成：请只给出其中一个。",
    "A preset is called by its name, such as 'copper', not {value!r}.":
        "预设以名称指定，例如 'copper'，而不是 {value!r}。",
    "A preset, or a dataset of the database":
        "预设，或数据库中的数据集",
    "A second Blender could not be started: {why}":
        "无法启动第二个 Blender：{why}",
    "A stack has at most {most} films; this one has {count}.":
        "层堆最多有 {most} 层薄膜；此层堆有 {count} 层。",
    "A stack is a text such as 'SiO2 0-1000 nm / Si', from the outside in, not {value!r}.":
        "层堆是形如 'SiO2 0-1000 nm / Si' 的文本，由外向内书写，而不是 {value!r}。",
    "A stack of {films} films has {indices} indices: outside, films and substrate; {given} were given.":
        "{films} 层薄膜的层堆有 {indices} 个折射率：外部、各薄膜和基底；给出了 {given} 个。",
    "A tab in the sidebar of the 3D Viewport":
        "3D 视图侧边栏中的标签",
    "A table has at most {most} entries, not {rows} × {columns}; take fewer rows or columns.":
        "表格最多有 {most} 个条目，而不是 {rows} × {columns}；请减少行数或列数。",
    "A thickness that varies becomes its middle.":
        "变化的厚度取其中间值。",
    "A thin layer after Granier and Heidrich, clean and fast, in Cycles and in EEVEE: the one to take first":
        "Granier 与 Heidrich 的薄层，干净快速，适用于 Cycles 和 EEVEE：首选",
    "A verification is running":
        "验证正在运行",
    "Absorption":
        "吸收",
    "Absorption over the depth is lost there: the color is that of the mean depth.":
        "随深度的吸收在该格式中会丢失：颜色取平均深度处的颜色。",
    "Active Slot":
        "活动槽",
    "Adapt White":
        "适应白点",
    "Add":
        "添加",
    "Add Asset Library":
        "添加资产库",
    "Add Facet & Film Group":
        "添加 Facet & Film 节点组",
    "Add a layer below the chosen one":
        "在所选膜层之下添加一层",
    "Add a node group of Facet & Film; one that the file has already is used again":
        "添加 Facet & Film 节点组；文件中已有的会被复用",
    "Add the materials and node groups to the Asset Browser, as a library of your preferences":
        "将材质和节点组作为偏好设置中的资产库添加到资产浏览器",
    "Against":
        "相邻",
    "Against: {:s}":
        "相邻：{:s}",
    "Air":
        "空气",
    "All Slots":
        "所有槽",
    "All materials of Facet & Film in this file are in its working space":
        "此文件中所有 Facet & Film 材质均已处于其工作色彩空间",
    "Amount":
        "数量",
    "An even sheen without marks":
        "均匀的光泽，没有痕迹",
    "An even, fine grain, for Roughness, Normal and Diffuse Color":
        "均匀细腻的颗粒，用于粗糙度、法线和漫射颜色",
    "Anisotropy":
        "各向异性",
    "Anisotropy is lost there.":
        "各向异性在该格式中会丢失。",
    "Another Version":
        "其他版本",
    "Apply":
        "应用",
    "Apply Finish":
        "应用表面处理",
    "Apply Material":
        "应用材质",
    "Apply Saved Preset":
        "应用已保存的预设",
    "Apply a material of Facet & Film first: there is nothing to save":
        "请先应用 Facet & Film 材质：没有可保存的内容",
    "Apply to Node":
        "应用到节点",
    "As published beside it":
        "同文中发表的另一种",
    "As smooth or rough as the preset says":
        "光滑或粗糙程度由预设决定",
    "At 0°":
        "0° 处",
    "At {place!r}: a bracket has no other; films that repeat are written '(TiO2 58 nm / SiO2 94 nm)x8'.":
        "在 {place!r} 处：括号不成对；重复的薄膜写作 '(TiO2 58 nm / SiO2 94 nm)x8'。",
    "At {place!r}: a film is named with its thickness, such as 'SiO2 100 nm', or with a range, 'SiO2 0-1000 nm'.":
        "在 {place!r} 处：薄膜须带厚度，如 'SiO2 100 nm'，或带范围，如 'SiO2 0-1000 nm'。",
    "At {place!r}: a layer is missing between two slashes or at an end.":
        "在 {place!r} 处：两个斜杠之间或一端缺少一层。",
    "At {place!r}: a thickness is from 0 nm on, the lower end of a range first.":
        "在 {place!r} 处：厚度不小于 0 nm，范围的下限写在前面。",
    "At {place!r}: films repeat 1 to {most} times, not {times}.":
        "在 {place!r} 处：薄膜可重复 1 到 {most} 次，而不是 {times} 次。",
    "At {place!r}: the last layer is what is below all films and has no thickness; name it after another ' / '.":
        "在 {place!r} 处：最后一层是所有薄膜之下的材料，没有厚度；请在另一个 ' / ' 之后写明。",
    "At {place!r}: what is outside stands before one bar, and there are more.":
        "在 {place!r} 处：外部材料写在一条竖线之前，此处有多条竖线。",
    "At {place!r}: {why}":
        "在 {place!r} 处：{why}",
    "Axis":
        "轴",
    "Azimuth":
        "方位角",
    "Bake":
        "烘焙",
    "Bake Spectral Preset":
        "烘焙光谱预设",
    "Bake a material of the catalogue or a dataset, in the light chosen here, and put it on the selected objects":
        "按此处选择的光烘焙目录中的材质或数据集，并赋予所选物体",
    "Bake a measured material first: there is nothing to bake again":
        "请先烘焙实测材质：没有可重新烘焙的内容",
    "Bake a measured material first: there is nothing to export":
        "请先烘焙一个实测材质：没有可导出的内容",
    "Bake a measurement from a file: tables of n and k, permittivity or reflectance in any layout and unit; refractiveindex.info, SOPRA, WVASE, Zemax, CGATS, JSON and others":
        "从文件烘焙测量数据：任意布局与单位的 n 与 k、介电常数或反射率表格；refractiveindex.info、SOPRA、WVASE、Zemax、CGATS、JSON 等",
    "Bake a measurement from the clipboard: a table of n and k, permittivity or reflectance":
        "从剪贴板烘焙测量数据：n 与 k、介电常数或反射率的表格",
    "Bake a preset first: this material is not one of Facet & Film":
        "请先烘焙预设：此材质不属于 Facet & Film",
    "Bake a preset into the selected group node; what is plugged into it stays":
        "将预设烘焙到选中的组节点；已有连线保留",
    "Bake every measured material of this file again, in the light and working space chosen above. Esc stops it, and then nothing is changed":
        "按上方选择的光源与工作空间重新烘焙此文件的所有实测材质。按 Esc 停止，且不作任何更改",
    "Bake these layers into the material: its roughness, its textures and what else you set stay":
        "将这些膜层烘焙到材质中：粗糙度、纹理及其他设置保持不变",
    "Bake this material's measurement again in the light and working space chosen here; what else you set stays":
        "按此处选择的光源与工作空间重新烘焙该材质的测量数据；其他设置保留",
    "Baking {:s}, {:d} more   (Esc stops)":
        "正在烘焙 {:s}，还剩 {:d} 个   （按 Esc 停止）",
    "Beckmann":
        "贝克曼",
    "Best":
        "最佳",
    "Bring all Facet & Film materials that were baked for another working space into this file's: baked "
    "again, and what you changed moved along. Esc stops it, and then nothing is changed":
        "将所有为其他工作色彩空间烘焙的 Facet & Film 材质转入此文件的空间：重新烘焙，您更改的内容一并转换。按 Esc 停止，此时不作任何更改",
    "Bring this file's materials by an older Facet & Film up to date; every value and link stays":
        "将此文件中由旧版 Facet & Film 创建的材质更新；所有数值与连线保留",
    "Brushed":
        "拉丝",
    "Brushed Circular":
        "环形拉丝",
    "Brushed, Circular":
        "拉丝，环形",
    "CIE standard observer":
        "CIE 标准观察者",
    "CIEDE2000 at most {:.2f}":
        "CIEDE2000 最大 {:.2f}",
    "CIEDE2000 {:.2f} on average, below {:.1f} in 95 %":
        "CIEDE2000 平均 {:.2f}，95 % 低于 {:.1f}",
    "CSV of the Curve":
        "曲线的 CSV",
    "CSV of the Spectrum":
        "光谱的 CSV",
    "Cast":
        "铸造",
    "Cauchy b":
        "柯西 b",
    "Cauchy c":
        "柯西 c",
    "Change":
        "更改",
    "Change Layers":
        "更改膜层",
    "Change the list of layers":
        "更改膜层列表",
    "Check":
        "核对",
    "Check Against a Measurement":
        "与测量值核对",
    "Choose a Material":
        "选择材质",
    "Choose a clear material first, such as water: it is what the face's normals point out of":
        "请先选择透明材质，例如水：面的法线从它指向外",
    "Choose a file: here stands what it is read as":
        "选择文件：此处显示它被读作什么",
    "Choose a material by its picture, above":
        "请在上方按图片选择材质",
    "Choose a material that is made of layers first, such as anodised titanium":
        "请先选择由膜层构成的材质，例如阳极氧化钛",
    "Citation":
        "引文",
    "Clean and fast, on every device and in EEVEE: the one to take first":
        "干净快速，适用于所有设备和 EEVEE：首选",
    "Clear Dispersive":
        "透明（色散）",
    "Clear Standard":
        "透明（标准）",
    "Clip":
        "裁剪",
    "Colour of a preset's mirror over the angle, for any shader":
        "预设的镜面颜色随角度变化，可用于任意着色器",
    "Colour over angle: cos_theta, r, g, b":
        "颜色随角度变化：cos_theta, r, g, b",
    "Columns":
        "列",
    "Common Face of Two Bodies":
        "两个物体的公共面",
    "Compare Measurements":
        "比较测量值",
    "Concentration":
        "浓度",
    "Cook and Torrance's own choice, with a wider foot":
        "库克与托兰斯的选择，尾部更宽",
    "Cook-Torrance OSL":
        "Cook–Torrance OSL",
    "Cook-Torrance Reference":
        "Cook–Torrance（参考）",
    "Cook-Torrance Standard":
        "Cook–Torrance（标准）",
    "Curve":
        "曲线",
    "Cut every channel off at 0 and 1":
        "将每个通道截断在 0 与 1",
    "Darken all colours of the material alike, until the largest channel fits":
        "将材质的所有颜色等比变暗，直到最大通道符合范围",
    "Data":
        "数据",
    "Dataset":
        "数据集",
    "Dataset {dataset!r} covers less than 50 nm of the visible, 400 to 700 nm; choose another.":
        "数据集 {dataset!r} 在可见光 400 至 700 nm 内的覆盖不足 50 nm；请另选一个。",
    "Dataset {dataset!r} has k but no n: no reflectance follows; choose another.":
        "数据集 {dataset!r} 只有 k 而没有 n：无法得出反射率；请另选一个。",
    "Depth":
        "深度",
    "Depth Color":
        "深度颜色",
    "Desaturate":
        "降低饱和度",
    "Deviation":
        "偏角",
    "Device":
        "设备",
    "Diffuse":
        "漫射",
    "Diffuse Color":
        "漫射颜色",
    "Dispersion":
        "色散",
    "Dispersion Curve":
        "色散曲线",
    "Dispersion is lost there.":
        "色散在该格式中会丢失。",
    "Dispersive":
        "色散",
    "Distribution":
        "分布",
    "Does this Blender render the published formulas? Find out on this machine:":
        "此 Blender 是否正确渲染已发表的公式？在本机上验证：",
    "Drained":
        "排液",
    "Drop Material":
        "放下材质",
    "Drop on {:s}   (Esc stops)":
        "放到 {:s} 上   (Esc 停止)",
    "Drop this material on an object: it goes into the slot of the face under the mouse":
        "将此材质放到物体上：进入鼠标下面所在的槽",
    "Dull and tarnished, rubbed bright at the edges":
        "暗淡失泽，边缘磨亮",
    "Edge Roughness":
        "边缘粗糙度",
    "Edge Tint":
        "边缘色调",
    "Edge Width":
        "边缘宽度",
    "Edges rubbed bright, for Roughness and Tint":
        "磨亮的边缘，用于粗糙度和染色",
    "Entries in the Object menu and in the context menus of objects, faces and material slots":
        "物体菜单以及物体、面和材质槽右键菜单中的条目",
    "Every parameter":
        "所有参数",
    "Every wavelength refracted by its own index, for rainbows in gems and prisms; noisier, and EEVEE shows it without them":
        "每个波长以各自的折射率折射，使宝石和棱镜呈现彩虹；噪点较多，EEVEE 中不显示彩虹",
    "Everything in this file is of this version":
        "此文件中的一切都是当前版本",
    "Everything that was baked":
        "烘焙的全部内容",
    "Exponent R":
        "指数 R",
    "Exponent T":
        "指数 T",
    "Export Measurement":
        "导出测量数据",
    "Extinction for red, green and blue":
        "红、绿、蓝的消光系数",
    "Extinction k":
        "消光系数 k",
    "F0 and Edge Tint":
        "F0 与边缘色调",
    "F82 Tint":
        "F82 色调",
    "F82 tint":
        "F82 色调",
    "Face Is Against":
        "面的另一侧",
    "Facet & Film Material...":
        "Facet & Film 材质...",
    "File":
        "文件",
    "File of a measured BRDF":
        "实测 BRDF 文件",
    "File of optical constants":
        "光学常数文件",
    "File to write":
        "要写入的文件",
    "File's Working Space":
        "文件的工作空间",
    "Film Anodising":
        "薄膜阳极氧化",
    "Film Heat Tint":
        "薄膜热着色",
    "Film OSL":
        "薄膜（OSL）",
    "Film Reference":
        "薄膜（参考）",
    "Film Standard":
        "薄膜（标准）",
    "Film Thickness":
        "薄膜厚度",
    "Films from the outside in":
        "由外向内的膜层",
    "Films of measured layers by an OSL script, to read: the formula at the angle of every facet":
        "由实测层构成的薄膜的 OSL 脚本，供阅读：按每个微面的角度计算的公式",
    "Films of measured layers, at the angle of every facet: slower and noisier, to compare with":
        "由实测膜层组成的薄膜，按每个微面的角度计算：较慢且噪点较多，用于对照",
    "Films of measured layers, clean and fast: the one to take first":
        "由实测膜层组成的薄膜，干净快速：首选",
    "Find a material by its name, its formula or any other name for it, and put it on the selected objects":
        "按名称、化学式或任何别名查找材质，并赋予所选物体",
    "Fingerprints":
        "指纹",
    "Fingerprints and wipe marks, for Roughness and Diffuse Color":
        "指纹和擦痕，用于粗糙度和漫射颜色",
    "Finish":
        "表面处理",
    "Finish: {:s}":
        "表面处理：{:s}",
    "First Thickness":
        "起始厚度",
    "Fit":
        "拟合",
    "Fit Measured BRDF":
        "拟合实测 BRDF",
    "Fit a model to a measured BRDF, put it in the material slot and save it as a preset of your own: .bsdf of RGL-EPFL, .binary of MERL, or points as text. Takes a few seconds; Esc stops it":
        "用模型拟合实测 BRDF，放入材质槽并另存为自己的预设：RGL-EPFL 的 .bsdf、MERL 的 .binary 或文本形式的点。需要几秒钟；按 Esc 停止",
    "Fitting {:s}: {:d} %   (Esc stops)":
        "正在拟合 {:s}：{:d} %   （Esc 停止）",
    "For exporters, not rendered":
        "供导出使用，不参与渲染",
    "Form":
        "格式",
    "Free over the angle, for colours that change with it; with two slopes at most":
        "随角度自由变化，用于随角变色的表面；最多两个斜率",
    "Fresnel":
        "菲涅耳",
    "Fresnel Ramp":
        "菲涅耳渐变",
    "Gamut":
        "色域",
    "Gaussian":
        "高斯",
    "Gaussian c":
        "高斯 c",
    "Give a preset that you saved another name":
        "为已保存的预设改名",
    "Give this material another finish; what it is made of stays":
        "为此材质换一种表面处理；其材料不变",
    "Glass and gems with the colours of the rainbow, each refracted by its own index":
        "带彩虹色的玻璃与宝石，每种颜色以各自的折射率折射",
    "Glass, liquids and gems of one index of refraction, coloured by the way through them":
        "单一折射率的玻璃、液体和宝石，颜色取决于光在其中的路径",
    "Gradient":
        "渐变",
    "Greatest Thickness":
        "最大厚度",
    "Group":
        "组",
    "Hammered":
        "锤纹",
    "Headers":
        "标题栏",
    "How many rms slopes the facets have":
        "微面均方根斜率的个数",
    "How the facets' slopes are distributed":
        "微面斜率的分布方式",
    "How the formula becomes a Cycles material":
        "公式如何成为 Cycles 材质",
    "IOR":
        "折射率",
    "IOR Below":
        "下层折射率",
    "Illuminant":
        "光源",
    "Image Rows":
        "图像行数",
    "Import Measurement":
        "导入测量数据",
    "In Object Mode select two meshes: the glass, and then the water":
        "在物体模式下选择两个网格：先选玻璃，再选水",
    "In Place":
        "原位",
    "Inside, unchanged":
        "在色域内，未改变",
    "Interference in the clear film is lost there.":
        "透明薄膜的干涉在该格式中会丢失。",
    "Into a slot of its own; in Edit Mode for the selected faces":
        "放入单独的槽；编辑模式下用于所选的面",
    "Into every material slot of every selected object":
        "放入每个所选物体的每个材质槽",
    "Into the active material slot of every selected object":
        "放入每个所选物体的活动材质槽",
    "Inwards":
        "向内",
    "Keep colours outside of the gamut":
        "保留色域外的颜色",
    "Keep it among your own presets, with what it was fitted from":
        "保存到自己的预设中，并注明拟合来源",
    "Large fields of view":
        "大视场",
    "Last Thickness":
        "末端厚度",
    "Layer":
        "膜层",
    "Layer From a File":
        "来自文件的膜层",
    "Layer From a File...":
        "来自文件的膜层…",
    "Layer Thickness":
        "层厚度",
    "Layer {place} of a stack needs n above 0 and k of at least 0 at every wavelength.":
        "层堆的第 {place} 层在每个波长处都需要 n 大于 0 且 k 不小于 0。",
    "Layered RGB OSL":
        "Layered RGB OSL",
    "Layered RGB Reference":
        "Layered RGB（参考）",
    "Layered RGB Standard":
        "Layered RGB（标准）",
    "Layers":
        "膜层",
    "Layers from the outside in, such as 'SiO2 0-1000 nm / Si'":
        "由外向内的膜层，例如 'SiO2 0-1000 nm / Si'",
    "Layers in Words":
        "膜层文字表示",
    "Least Thickness":
        "最小厚度",
    "Leave":
        "保留",
    "Left out, as they take no materials or are linked: {:s}":
        "已略过（不接受材质或为链接数据）：{:s}",
    "Length":
        "长度",
    "Light":
        "光",
    "Light and Gamut":
        "光源与色域",
    "Light in which the material has its colour; D65 is daylight, and white in Blender":
        "决定材质颜色的光；D65 是日光，在 Blender 中为白色",
    "Linear Rec.709, Blender's default":
        "线性 Rec.709，Blender 的默认值",
    "Lower Normal":
        "下层法线",
    "Make Local":
        "设为本地",
    "Make a material of one Principled BSDF that comes closest to this one, and put it in its place: for "
    "baking textures, for other engines and exporters. The material itself stays in the file":
        "创建一个由单个原理化 BSDF 构成、最接近此材质的材质，并放到其位置：用于烘焙纹理、其他引擎和导出器。原材质保留在文件中",
    "Make one face of two clear bodies that touch, as water does in a glass. Select the glass, then the water: the faces of the water on the glass get their material, and the glass's below them go":
        "把相接触的两个透明物体（如杯中的水）的面合为一个。先选玻璃，再选水：水贴着玻璃的面得到公共面材质，其下玻璃的面被删除",
    "Make the active material itself over, wherever it is used":
        "直接改造活动材质，无论它用在何处",
    "Make the active material slot the material that you saved":
        "将活动材质槽设为已保存的材质",
    "Make this linked or overridden material the file's own: changes in its library no longer arrive":
        "将此关联或覆盖的材质变为此文件自有：其库中的更改不再同步",
    "Match Working Space":
        "匹配工作色彩空间",
    "Material":
        "材质",
    "Material Shelf":
        "材质架",
    "Material: a preset's name, or a dataset such as main/Cu/Johnson. Type to search":
        "材质：预设名称，或数据集如 main/Cu/Johnson。输入即可搜索",
    "Matt, with an even, fine grain":
        "哑光，颗粒均匀细腻",
    "Measured Material":
        "实测材质",
    "Measurement":
        "测量",
    "Menus":
        "菜单",
    "Metals, plastics and stone, clean and fast, in Cycles and in EEVEE: the one to take first":
        "金属、塑料与石材，干净快速，适用于 Cycles 和 EEVEE：首选",
    "Model":
        "模型",
    "Move the chosen layer inwards":
        "将所选膜层向内移动",
    "Move the chosen layer outwards":
        "将所选膜层向外移动",
    "Name a saved preset, and a new name with at least one letter":
        "请指定已保存的预设和至少含一个字母的新名称",
    "Nearest":
        "最接近",
    "New Materials Render by":
        "新材质的渲染方式",
    "New Name":
        "新名称",
    "New Slot":
        "新槽",
    "No face of {:s} lies on {:s} with its normal the other way: duplicate the wet faces of the one, flip their normals, and close them to the other":
        "{:s} 没有法线相反且贴在 {:s} 上的面：请复制其中一个的接触面，翻转法线，再封闭成另一个",
    "Nodes updated: {:d}":
        "已更新节点：{:d}",
    "Noise Detail":
        "噪波细节",
    "Noise Scale":
        "噪波缩放",
    "Normal":
        "法线",
    "OSL Standard":
        "OSL 标准",
    "OSL needs the CPU or OptiX: {:s} is shown in its place on this device":
        "OSL 需要 CPU 或 OptiX：在此设备上将显示“{:s}”",
    "Observer":
        "观察者",
    "Of a file that holds or can mean several things: which. Empty where its meaning is plain":
        "当文件包含多项内容或有多种含义时：选择哪一项。含义明确时留空",
    "Of {word!r} only the normal reflectance is known, and a stack needs n and k; choose another dataset.":
        "{word!r} 只有正入射反射率，而层堆需要 n 和 k；请选择另一个数据集。",
    "Open Shading Language is off: {:s} is shown in its place until you switch it on in the Render properties":
        "开放着色语言未启用：在渲染属性中启用之前，将显示“{:s}”",
    "Open a material in the Shader Editor first":
        "请先在着色器编辑器中打开材质",
    "Open all materials as pictures: each click puts one on the selected objects, until Esc. The first time this adds the library Facet & Film to your preferences":
        "以图片打开所有材质：每次点击将一种材质赋予所选物体，直到按 Esc。首次使用会将资产库 Facet & Film 添加到偏好设置",
    "Open an Asset Browser and choose the library {:s}: drag a material onto an object":
        "打开资产浏览器并选择库 {:s}：将材质拖到物体上",
    "Outside":
        "外部介质",
    "Outside IOR":
        "外部折射率",
    "Outside: {:s}, channels moved by up to {:.3f}":
        "色域外：{:s}，通道最多改变 {:.3f}",
    "Outwards":
        "向外",
    "Parallel streaks, and highlights drawn out across them":
        "平行纹路，高光横向拉长",
    "Parallel streaks, for Roughness, Normal, Tangent and Diffuse Color":
        "平行纹路，用于粗糙度、法线、切线和漫射颜色",
    "Parameters":
        "参数",
    "Paste Measurement":
        "粘贴测量数据",
    "Pits":
        "凹坑",
    "Place":
        "位置",
    "Polished":
        "抛光",
    "Preset":
        "预设",
    "Preset or dataset":
        "预设或数据集",
    "Preset or dataset to compare":
        "要比较的预设或数据集",
    "Preset or dataset to compare with":
        "用于比较的预设或数据集",
    "Preset's Own":
        "预设自带",
    "Presets":
        "预设",
    "Principled Twin":
        "原理化孪生材质",
    "Published Scale":
        "原文尺度",
    "Put this material on the selected objects. What you made by hand stays: the slot gets a new material":
        "将此材质赋予所选物体。您手工制作的材质会保留：槽中放入新材质",
    "Randomness":
        "随机性",
    "Re-bake":
        "重新烘焙",
    "Re-bake All Materials":
        "重新烘焙所有材质",
    "Read As":
        "读作",
    "Read the Documents":
        "阅读文档",
    "Realisation":
        "实现方式",
    "Reference":
        "参考",
    "Reflectance at normal incidence":
        "正入射反射率",
    "Reflectance at normal incidence and F82 tint for red, green and blue":
        "红、绿、蓝的正入射反射率与 F82 色调",
    "Refractive Index":
        "折射率",
    "Refractive Index n":
        "折射率 n",
    "Refractive index and extinction for red, green and blue":
        "红、绿、蓝的折射率与消光系数",
    "Refractive index for red, green and blue":
        "红、绿、蓝的折射率",
    "Remove":
        "移除",
    "Remove Asset Library":
        "移除资产库",
    "Remove the chosen layer":
        "移除所选膜层",
    "Rename Preset":
        "重命名预设",
    "Render every model and realisation in a second Blender, compare the pixels with the published formulas, and open the report. Takes one to five minutes; Esc stops it":
        "在另一个 Blender 中渲染所有模型与实现方式，将像素与已发表的公式比较并打开报告。需一至五分钟；按 Esc 停止",
    "Render this material by another realisation; every value and link that you set stays":
        "以另一种实现方式渲染此材质；所有数值与连线保留",
    "Renders by":
        "渲染方式",
    "Rotation":
        "旋转",
    "Rough, 1982":
        "粗糙，1982",
    "Roughness":
        "糙度",
    "Rows":
        "行",
    "Runs in a second Blender, which Blender as a Python module lacks: run python -m addon verify":
        "需在第二个 Blender 中运行，而作为 Python 模块的 Blender 没有：请运行 python -m addon verify",
    "Samples":
        "样本",
    "Sampling Width":
        "采样宽度",
    "Sandblasted":
        "喷砂",
    "Satin":
        "缎面",
    "Save Preset":
        "保存预设",
    "Save as Preset":
        "另存为预设",
    "Save the active material under a name of your own, or delete a saved one":
        "以自定义名称保存活动材质，或删除已保存的材质",
    "Say what this face of a clear body is against: air, or another clear material, as water in a glass is. In Edit Mode the selected faces get a material of their own":
        "指定透明物体的这个面与什么相邻：空气，或另一种透明材质，如杯中的水。在编辑模式下，所选面得到各自的材质",
    "Scale":
        "缩放",
    "Scene Scale":
        "场景比例",
    "Scene-linear space that the colours are written in":
        "写入颜色所用的场景线性空间",
    "Scratch Roughness":
        "划痕粗糙度",
    "Scratched":
        "划痕",
    "Scratches and hairlines, for Roughness, Normal and Diffuse Color":
        "划痕和细纹，用于粗糙度、法线和漫射颜色",
    "Search":
        "搜索",
    "Search Facet & Film Materials":
        "搜索 Facet & Film 材质",
    "See-through":
        "透视",
    "See-through Shadows":
        "透光阴影",
    "Select a group node of Facet & Film first":
        "请先选择 Facet & Film 组节点",
    "Select a group of Facet & Film, or add one: Add, Facet & Film":
        "请选择 Facet & Film 节点组，或添加：添加，Facet & Film",
    "Select an object first: the material goes into its active material slot":
        "请先选择一个物体：材质会放入其活动材质槽",
    "Select the object whose face it is":
        "请选择该面所属的物体",
    "Selected Node":
        "所选节点",
    "Several slopes become one of the same rms.":
        "多个斜率合为一个均方根相同的斜率。",
    "Shadows and caustics are the other program's own.":
        "阴影和焦散由另一程序自行处理。",
    "Shallow dimples side by side, each with its own highlight":
        "浅凹窝相邻排列，各有高光",
    "Shallow dimples, for Roughness and Normal":
        "浅凹窝，用于粗糙度和法线",
    "Shelf":
        "材质架",
    "Show F0, F82 and how many CIEDE2000 typed-in values or a material lie from a measured material":
        "显示 F0、F82，以及输入的数值或材质与实测材质的 CIEDE2000 差异",
    "Show all measurements of the same material side by side: published values differ from lab to lab":
        "并列显示同一材质的所有测量值：各实验室发表的数值有所不同",
    "Show or hide a shelf of all materials along the 3D Viewport, to click on or to drag onto objects":
        "显示或隐藏 3D 视图边上的材质架，可点击或拖到物体上",
    "Sidebar":
        "侧边栏",
    "Slope Ratio 2":
        "斜率比 2",
    "Slope Ratio 3":
        "斜率比 3",
    "Slope Ratio 4":
        "斜率比 4",
    "Slopes":
        "斜率",
    "Small fields of view; what displays are calibrated for":
        "小视场；显示器据此校准",
    "Smooth, with clear reflections that are soft at their edges":
        "光滑，反射清晰，边缘柔和",
    "Smooth, with deep scratches and hairlines in all directions":
        "光滑，带有各方向的深划痕和细纹",
    "Smooth, with fingerprints and the marks of wiping":
        "光滑，带有指纹和擦痕",
    "Smudge Roughness":
        "污迹粗糙度",
    "Smudged":
        "污迹",
    "Softness":
        "柔和度",
    "Specular":
        "镜面",
    "Standard":
        "标准",
    "Standard as an OSL script: needs Open Shading Language switched on":
        "标准方式的 OSL 脚本：需要打开 Open Shading Language",
    "Standard; Dispersive for diamond, lead crystal and what else is known by its rainbow":
        "标准；钻石、铅晶质玻璃等以彩虹闻名者用色散",
    "Stopped: no material was changed":
        "已停止：没有材质被更改",
    "Stopped: nothing was fitted":
        "已停止：未进行拟合",
    "Streaks in circles, as from a lathe or on the foot of a pan":
        "环形纹路，如车床加工或锅底",
    "Streaks in circles, for Roughness, Normal, Tangent and Diffuse Color":
        "环形纹路，用于粗糙度、法线、切线和漫射颜色",
    "Substrate":
        "基底",
    "Substrate From a File...":
        "来自文件的基底…",
    "Switch Realisation":
        "切换实现方式",
    "Table":
        "表格",
    "Take a measurement of your own as a layer: a file of n and k":
        "以您自己的测量作为膜层：含 n 和 k 的文件",
    "Take the library off the Asset Browser again, and with it the pictures to choose from; materials stay":
        "从资产浏览器中移除该库以及可供选择的图片；材质保留",
    "Tangent":
        "切线",
    "Tarnish":
        "失泽",
    "Temperature":
        "温度",
    "Texture":
        "纹理",
    "Texture Share":
        "纹理占比",
    "The asset library {:s} was added to your preferences; the extension's own take it out again":
        "资产库 {:s} 已添加到偏好设置；可在扩展的偏好设置中移除",
    "The chosen layer":
        "所选膜层",
    "The coarse, dull skin of a sand mould, with pits":
        "砂型铸造的粗糙暗淡表皮，带凹坑",
    "The colour inside that looks most alike, by CIEDE2000":
        "色域内按 CIEDE2000 看来最相近的颜色",
    "The devices that are switched on under System, Cycles Render Devices":
        "在“系统”的“Cycles 渲染设备”中启用的设备",
    "The facets' distribution becomes GGX, whose highlights have wider tails.":
        "微面分布变为 GGX，其高光拖尾更宽。",
    "The file {file!r} cannot be read.":
        "无法读取文件 {file!r}。",
    "The film's colors over the angle become two: face on and at 82°.":
        "薄膜随角度变化的颜色简化为两个：正视和 82°。",
    "The films come to {optical:.0f} nm of n times thickness, and interference is calculated to {most:.0f}; "
    "make them thinner, or what is thick the layer below.":
        "各薄膜的 n 乘厚度合计 {optical:.0f} nm，而干涉只计算到 {most:.0f}；请减小厚度，或将厚层作为底层。",
    "The folder of {file!r} does not exist; make it first, or name another.":
        "{file!r} 所在的文件夹不存在；请先创建，或另指定一个。",
    "The greatest thickness in nanometres":
        "最大厚度，单位纳米",
    "The index of refraction is lost there: 1.5 is taken.":
        "折射率在该格式中会丢失：取 1.5。",
    "The index {text} needs n above 0 and k of at least 0 from 360 to 780 nm.":
        "折射率 {text} 在 360 到 780 nm 内需要 n 大于 0 且 k 不小于 0。",
    "The library is in your preferences already":
        "该库已在偏好设置中",
    "The library is not in the preferences":
        "该库不在偏好设置中",
    "The library {:s} is no longer shown":
        "不再显示资产库 {:s}",
    "The measured points: wavelength_nm, n, k":
        "测量点：wavelength_nm, n, k",
    "The medium outside is a number from 1 to 4 or a clear material, such as 1.33 or 'water', not {value!r}.":
        "外部介质须为 1 到 4 之间的数，或透明材料，例如 1.33 或 'water'，而不是 {value!r}。",
    "The medium outside is named by its index, a preset or a dataset; {medium} is a measurement of your own: give its index.":
        "外部介质以折射率、预设或数据集指定；{medium} 是您自己的测量数据：请给出其折射率。",
    "The preset to rename":
        "要重命名的预设",
    "The preset {file!r} cannot be read.":
        "无法读取预设 {file!r}。",
    "The processor":
        "处理器",
    "The published formula as an OSL script: needs Open Shading Language switched on in the Render properties, on the CPU or OptiX; EEVEE shows Standard":
        "以 OSL 脚本实现的论文公式：需要在渲染属性中打开 Open Shading Language，用于 CPU 或 OptiX；EEVEE 显示标准方式",
    "The published formula itself, on every device: slower and noisier, to compare with; EEVEE shows Standard":
        "论文公式本身，适用于所有设备：较慢且噪点较多，用于对照；EEVEE 显示标准方式",
    "The published formula of Cook and Torrance 1982 as an OSL script, to read beside the paper":
        "Cook 与 Torrance 1982 论文公式的 OSL 脚本，可对照论文阅读",
    "The published formula of Cook and Torrance 1982 itself: slower and noisier, to compare with":
        "Cook 与 Torrance 1982 的论文公式本身：较慢且噪点较多，用于对照",
    "The published formula of Granier and Heidrich 2003 as an OSL script, to read beside the paper":
        "Granier 与 Heidrich 2003 论文公式的 OSL 脚本，可对照论文阅读",
    "The published formula of Granier and Heidrich 2003 itself: slower and noisier, to compare with":
        "Granier 与 Heidrich 2003 的论文公式本身：较慢且噪点较多，用于对照",
    "The rough finish of the paper's copper vase":
        "论文中铜花瓶的粗糙表面",
    "The same layers as one line, such as 'SiO2 0-1000 nm / Si': it can be copied and pasted":
        "同样的膜层写成一行，例如 'SiO2 0-1000 nm / Si'：可复制和粘贴",
    "The scene-linear space of this file":
        "此文件的场景线性空间",
    "The scene-linear space of this file has no three primaries; choose another OpenColorIO "
    "configuration, or name a space.":
        "此文件的场景线性空间没有三原色；请选择其他 OpenColorIO 配置，或指定一个色彩空间。",
    "The second Blender ended with status {:d}: {:s}":
        "第二个 Blender 以状态 {:d} 结束：{:s}",
    "The shader {shader} does not compile: {why}":
        "着色器 {shader} 无法编译：{why}",
    "The shelf stands in a 3D Viewport in Object Mode":
        "材质架位于物体模式下的 3D 视图中",
    "The simplest of the others of which no other comes clearly closer":
        "其余选项中最简单且没有其他明显更接近的一种",
    "The skin of a sand mould, for Roughness and Normal":
        "砂型表皮，用于粗糙度和法线",
    "The thickness is a range, from which the material's own, a texture or a gradient take theirs":
        "厚度为一个范围，材质自身、纹理或渐变从中取值",
    "The thickness must be from {low:g} to {high:g} nm, as the stack says; it is {given:g}.":
        "厚度须在层堆给定的 {low:g} 到 {high:g} nm 之间；现为 {given:g}。",
    "The thickness of a film must be at least 0 nm; that of layer {place} is {thickness:g}.":
        "薄膜厚度不得小于 0 nm；第 {place} 层为 {thickness:g}。",
    "The thickness of {word!r} must be from 0 nm on, the lower end of a range first; it is {low:g} to {high:g} nm.":
        "{word!r} 的厚度不得小于 0 nm，且下限在前；现为 {low:g} 到 {high:g} nm。",
    "The verification was stopped; there is no report":
        "验证已停止；没有报告",
    "Their Finish":
        "其表面处理",
    "There is a preset called {:s} already":
        "已有名为 {:s} 的预设",
    "There is no material of Facet & Film called {name!r}.":
        "Facet & Film 中没有名为 {name!r} 的材质。",
    "There is no material {material!r} in this file any more.":
        "此文件中已没有材质 {material!r}。",
    "Thickness":
        "厚度",
    "Thickness in nanometres of the oxide that a voltage grows on a metal":
        "电压在金属上生成的氧化物的厚度（纳米）",
    "Thickness in nanometres of the oxide that heat grows on a metal":
        "加热在金属上生成的氧化物的厚度（纳米）",
    "Thickness in nanometres that varies by noise, a gradient or a texture":
        "随噪波、渐变或纹理变化的厚度（纳米）",
    "Thickness in nanometres that varies over the surface, and the lower normal tilted along it":
        "随表面变化的厚度（纳米），以及随之倾斜的下层法线",
    "Thickness in nanometres; where it varies, the least":
        "厚度，单位纳米；可变时为最小值",
    "Thin Walled":
        "薄壁",
    "This Blender is built without OSL: take Reference or Standard, which render the same material":
        "此 Blender 未包含 OSL：请使用参考或标准方式，渲染同一材质",
    "This Blender lacks its module oslquery, which OSL scripts need: take Reference or Standard":
        "此 Blender 缺少 OSL 脚本所需的 oslquery 模块：请使用参考或标准方式",
    "This engine renders Standard in its place: for this realisation choose Cycles in the Render properties":
        "此引擎改用标准方式渲染：要使用此实现，请在渲染属性中选择 Cycles",
    "This file has no material with a measurement: bake a preset first":
        "此文件没有带测量数据的材质：请先烘焙预设",
    "This file is no preset of Facet & Film.":
        "此文件不是 Facet & Film 的预设。",
    "This material is the file's own already":
        "此材质已是此文件自有",
    "This model has no roughness that a finish could vary":
        "此模型没有可由表面处理改变的粗糙度",
    "Time":
        "时间",
    "Tint":
        "染色",
    "To":
        "放到",
    "Towards grey of the same luminance, until inside: the 1982 paper's way":
        "朝相同亮度的灰色移动，直到进入色域：1982 年论文的方法",
    "Under this OpenColorIO configuration pixels do not come back from an OpenEXR file as they were "
    "rendered, so nothing can be verified: use one that has a role for data, or start Blender without it.":
        "在此 OpenColorIO 配置下，像素从 OpenEXR 文件读回后与渲染时不同，因此无法验证：请使用带有数据角色的配置，或不使用它启动 Blender。",
    "Unevenness":
        "不均匀度",
    "Update Materials":
        "更新材质",
    "Usual":
        "常用",
    "Varies":
        "可变",
    "Vector":
        "矢量",
    "Verdict":
        "结论",
    "Verify Against the Formulas":
        "对照公式验证",
    "Verify on CPU":
        "在 CPU 上验证",
    "Verify on GPU":
        "在 GPU 上验证",
    "Verifying {:s}":
        "正在验证 {:s}",
    "Verifying: starting a second Blender …":
        "正在验证：启动第二个 Blender …",
    "Voltage":
        "电压",
    "Wavelengths":
        "波长",
    "Wear":
        "磨损",
    "Weight 1":
        "权重 1",
    "Weight 2":
        "权重 2",
    "Weight 3":
        "权重 3",
    "Weight 4":
        "权重 4",
    "What is below all layers":
        "所有膜层之下的材料",
    "What is below all layers, without a thickness: a metal, a glass, air for a soap film":
        "所有膜层之下的材料，无厚度：金属、玻璃，肥皂膜则为空气",
    "What is on the face's other side":
        "面的另一侧是什么",
    "What is outside a stack must not absorb, and this has k up to {k:.2g}; name something clear, such as "
    "air or water.":
        "层堆外部的材料不得有吸收，而此材料的 k 高达 {k:.2g}；请选择透明材料，如空气或水。",
    "What is plugged into {:s} stays behind":
        "连接到 {:s} 的内容不会导出",
    "What is seen through arrives opaque there.":
        "透明材质在该格式中会变为不透明。",
    "What the layer is of: a formula such as SiO2, a preset, a dataset, a file, or an index such as 1.38 or 2.5+0.1i. Type to search":
        "膜层的材料：化学式如 SiO2、预设、数据集、文件，或折射率如 1.38 或 2.5+0.1i。输入即可搜索",
    "What the layers are in: air, or something clear such as water":
        "膜层所处的介质：空气，或水等透明物质",
    "What the reflectance F may be":
        "反射率 F 的形式",
    "What the surface is in: air, an index such as 1.33, or a clear material such as water":
        "表面所处的介质：空气、折射率（如 1.33）或透明材质（如水）",
    "What this material does with light has no counterpart there: its color and gloss at a glance remain.":
        "此材质对光的作用在那里没有对应物：仅保留大致的颜色和光泽。",
    "What to call it":
        "新的叫法",
    "What to compare":
        "比较的内容",
    "What to do with colours that the working space cannot hold":
        "如何处理工作空间无法容纳的颜色",
    "What to do with the list":
        "对列表的操作",
    "What to render the probes on":
        "用于渲染测试样本的设备",
    "What to write":
        "写入的内容",
    "What was done to the surface":
        "表面经过怎样的处理",
    "Where the material goes":
        "材质放到哪里",
    "Where to Find It":
        "在哪里找到",
    "Which group to add":
        "要添加的组",
    "Which layer is of it":
        "由其构成的膜层",
    "Which material to apply":
        "要应用的材质",
    "Whitening":
        "泛白",
    "Width":
        "宽度",
    "Wipe Marks":
        "擦痕",
    "Workbench shows the viewport colour only: choose Cycles in the Render properties":
        "Workbench 只显示视图颜色：请在渲染属性中选择 Cycles",
    "Working Space":
        "工作空间",
    "Worn Edges":
        "磨损边缘",
    "Write the active material as its node holds it now: JSON, CSV or MaterialX":
        "按节点当前的内容写出活动材质：JSON、CSV 或 MaterialX",
    "Wrote {:s}":
        "已写入 {:s}",
    "You have saved no preset yet":
        "尚未保存任何预设",
    "a space of its own":
        "自定义色彩空间",
    "alike":
        "几乎相同",
    "average daylight (superseded), 6774 K":
        "平均日光（已弃用），6774 K",
    "broadband fluorescent, D50 simulator, 5000 K":
        "宽带荧光灯，D50 模拟器，5000 K",
    "broadband fluorescent, D65 simulator, 6500 K":
        "宽带荧光灯，D65 模拟器，6500 K",
    "broadband fluorescent, cool white deluxe, 4150 K":
        "宽带荧光灯，豪华冷白，4150 K",
    "colour enhanced high pressure sodium lamp, 2510 K":
        "显色改进型高压钠灯，2510 K",
    "cool white fluorescent, 4230 K":
        "冷白荧光灯，4230 K",
    "dataset {dataset!r} is unknown. Datasets are named 'shelf/book/page', as refractiveindex.info does; a search finds them.":
        "未知数据集 {dataset!r}。数据集按 refractiveindex.info 的方式命名为“shelf/book/page”；可用搜索查找。",
    "dataset {dataset!r} is unknown; did you mean {near}? Datasets are named 'shelf/book/page', as refractiveindex.info does; a search finds them.":
        "未知数据集 {dataset!r}；您是指 {near} 吗？数据集按 refractiveindex.info 的方式命名为“shelf/book/page”；可用搜索查找。",
    "daylight fluorescent, 6350 K":
        "日光色荧光灯，6350 K",
    "daylight fluorescent, 6430 K":
        "日光色荧光灯，6430 K",
    "daylight, 5000 K":
        "日光，5000 K",
    "daylight, 5500 K":
        "日光，5500 K",
    "daylight, 6000 K":
        "日光，6000 K",
    "daylight, 6500 K":
        "日光，6500 K",
    "deluxe fluorescent, 2900 K":
        "豪华型荧光灯，2900 K",
    "deluxe fluorescent, 4090 K":
        "豪华型荧光灯，4090 K",
    "deluxe fluorescent, 4890 K":
        "豪华型荧光灯，4890 K",
    "direct sunlight at noon (superseded), 4874 K":
        "正午直射阳光（已弃用），4874 K",
    "equal energy":
        "等能",
    "fair":
        "尚可",
    "finish":
        "表面处理",
    "fluorescent, D65 simulator, 6510 K":
        "荧光灯，D65 模拟器，6510 K",
    "good":
        "良好",
    "halophosphate fluorescent, 2930 K":
        "卤磷酸盐荧光灯，2930 K",
    "halophosphate fluorescent, 3970 K":
        "卤磷酸盐荧光灯，3970 K",
    "halophosphate fluorescent, 6280 K":
        "卤磷酸盐荧光灯，6280 K",
    "high pressure metal halide lamp, 3140 K":
        "高压金属卤化物灯，3140 K",
    "high pressure metal halide lamp, 4000 K":
        "高压金属卤化物灯，4000 K",
    "high pressure metal halide lamp, 4040 K":
        "高压金属卤化物灯，4040 K",
    "high pressure sodium lamp, 1960 K":
        "高压钠灯，1960 K",
    "incandescent lamp, 2856 K":
        "白炽灯，2856 K",
    "indoor daylight, 5100 K":
        "室内日光，5100 K",
    "indoor daylight, 6600 K":
        "室内日光，6600 K",
    "it said nothing":
        "没有任何输出",
    "light white fluorescent, 4150 K":
        "浅白荧光灯，4150 K",
    "multi-band fluorescent, 2980 K":
        "多基色荧光灯，2980 K",
    "multi-band fluorescent, 3900 K":
        "多基色荧光灯，3900 K",
    "multi-band fluorescent, 5040 K":
        "多基色荧光灯，5040 K",
    "n and k":
        "n 与 k",
    "name must be a text with at least one letter, not {text!r}.":
        "名称须为至少含一个字母的文本，而不是 {text!r}。",
    "north sky daylight, 7500 K":
        "北天日光，7500 K",
    "preset":
        "预设",
    "preset {preset!r} is unknown; what fits these words: {found}.":
        "未知预设 {preset!r}；与这些词相符的有：{found}。",
    "stack must be layers from the outside in, such as 'SiO2 0-1000 nm / Si', not {value!r}.":
        "stack 必须是由外向内的各层，例如 'SiO2 0-1000 nm / Si'，而不是 {value!r}。",
    "thickness_range must be (least, greatest) in nm, not ({least:g}, {greatest:g}).":
        "thickness_range 必须是以 nm 为单位的（最小，最大），而不是 ({least:g}, "
        "{greatest:g})。",
    "this model cannot, because away from its highlights it is not evenly diffuse, as where fibres or flakes send light back":
        "该模型无法胜任，因为高光以外并非均匀漫反射，例如纤维或薄片会将光反射回去",
    "this model cannot, because its colour changes with the angle in another way than one Fresnel term on facets does":
        "该模型无法胜任，因为颜色随角度的变化不同于微面上的单一菲涅耳项",
    "this model cannot, because its highlights have another shape than facets of a few slopes make, as those of flakes":
        "该模型无法胜任，因为高光的形状不同于少数斜率的微面，例如薄片的高光",
    "this model cannot, because towards grazing it reflects otherwise than facets do":
        "该模型无法胜任，因为掠射时的反射不同于微面",
    "three-band fluorescent, 2980 K":
        "三基色荧光灯，2980 K",
    "three-band fluorescent, 3000 K":
        "三基色荧光灯，3000 K",
    "three-band fluorescent, 4000 K":
        "三基色荧光灯，4000 K",
    "three-band fluorescent, 4010 K":
        "三基色荧光灯，4010 K",
    "three-band fluorescent, 4850 K":
        "三基色荧光灯，4850 K",
    "three-band fluorescent, 5000 K":
        "三基色荧光灯，5000 K",
    "three-band fluorescent, 5850 K":
        "三基色荧光灯，5850 K",
    "warm white fluorescent, 2940 K":
        "暖白荧光灯，2940 K",
    "white LED, blue with phosphor, 2730 K":
        "白光 LED，蓝光加荧光粉，2730 K",
    "white LED, blue with phosphor, 3000 K":
        "白光 LED，蓝光加荧光粉，3000 K",
    "white LED, blue with phosphor, 4100 K":
        "白光 LED，蓝光加荧光粉，4100 K",
    "white LED, blue with phosphor, 5110 K":
        "白光 LED，蓝光加荧光粉，5110 K",
    "white LED, blue with phosphor, 6600 K":
        "白光 LED，蓝光加荧光粉，6600 K",
    "white LED, blue with phosphor, and red, 2850 K":
        "白光 LED，蓝光加荧光粉与红光，2850 K",
    "white LED, red, green and blue, 2840 K":
        "白光 LED，红绿蓝，2840 K",
    "white LED, violet with phosphor, 2720 K":
        "白光 LED，紫光加荧光粉，2720 K",
    "white LED, violet with phosphor, 4070 K":
        "白光 LED，紫光加荧光粉，4070 K",
    "white fluorescent, 3450 K":
        "白色荧光灯，3450 K",
    "{:d} lie below them in part: cut {:s} where the common face ends":
        "{:d} 个面只是部分位于其下：请在公共面结束处切割 {:s}",
    "{:d} materials baked again":
        "已重新烘焙 {:d} 个材质",
    "{:d} objects":
        "{:d} 个物体",
    "{:d} used, {:d} left out":
        "使用 {:d} 个，舍去 {:d} 个",
    "{:s} applied":
        "已应用 {:s}",
    "{:s} baked from {:s}: largest CIEDE2000 of the fit {:.2f}":
        "{:s} 已由 {:s} 烘焙：拟合的最大 CIEDE2000 为 {:.2f}",
    "{:s} fitted, CIEDE2000 {:.2f} on average: {:s}":
        "{:s} 已拟合，CIEDE2000 平均 {:.2f}：{:s}",
    "{:s} has no clear material: give it one first, such as glass or water":
        "{:s} 没有透明材质：请先赋予一种，例如玻璃或水",
    "{:s} is linked: update it in {:s}":
        "{:s} 是链接的：请在 {:s} 中更新",
    "{:s} is the file's own now":
        "{:s} 现为此文件自有",
    "{:s} on {:s}":
        "{:s} 已应用到 {:s}",
    "{:s} renders by {:s}":
        "{:s} 的渲染方式：{:s}",
    "{:s} takes no materials: select a mesh, curve, surface, text or volume":
        "{:s} 不接受材质：请选择网格、曲线、曲面、文本或体积",
    "{:s} was baked for {:s}, but this file's working space is {:s}: its colors are off":
        "{:s} 是为 {:s} 烘焙的，但此文件的工作色彩空间是 {:s}：其颜色有偏差",
    "{:s} was edited by hand and stays as it is":
        "{:s} 已被手动编辑，保持原样",
    "{:s} was made by a newer Facet & Film: install that one to change it":
        "{:s} 由较新的 Facet & Film 制作：请安装该版本以修改",
    "{:s}: finish {:s}":
        "{:s}：表面处理 {:s}",
    "{:s}: version {:d}, now {:d}":
        "{:s}：版本 {:d}，现为 {:d}",
    "{:s}: {:.1f} CIEDE2000 from {:s} on average over the angle":
        "{:s}：随角度平均为 {:.1f} CIEDE2000，相对于 {:s}",
    "{:s}: {:d} faces of {:s}; {:d} faces of {:s} below them went":
        "{:s}：{:d} 个面属于 {:s}；其下 {:d} 个面已从 {:s} 删除",
    "{dataset!r} is no dataset of the database; name one, or a material of it.":
        "{dataset!r} 不是数据库中的数据集；请指定一个数据集或其中的材质。",
    "{file!r} cannot be written: {why}; name another place.":
        "无法写入 {file!r}：{why}；请另指定位置。",
    "{file!r} has a heading that does not name theta_i, phi_i, theta_o, phi_o and a column for every number.":
        "{file!r} 的表头没有列出 theta_i、phi_i、theta_o、phi_o 以及每个数值对应的列。",
    "{file!r} has tables of the wrong dimensions: download it again.":
        "{file!r} 中表格的维度不对：请重新下载。",
    "{file!r} has {count} columns without a heading: name them, as in theta_i phi_i theta_o phi_o 450 550 650.":
        "{file!r} 有 {count} 列但没有表头：请为各列命名，例如 theta_i phi_i theta_o phi_o 450 550 650。",
    "{file!r} has {count} usable points; a fit needs {fewest}, and 400 where they are noisy.":
        "{file!r} 有 {count} 个可用的点；拟合需要 {fewest} 个，有噪声时需要 400 个。",
    "{file!r} has {sizes} entries; a file of the MERL database has 90 × 90 × 180.":
        "{file!r} 有 {sizes} 个条目；MERL 数据库的文件有 90 × 90 × 180 个。",
    "{file!r} holds no measured BRDF: take .bsdf of RGL-EPFL, .binary of MERL, or a text of points, each θi φi θo φo and red green blue.":
        "{file!r} 不含实测 BRDF：请使用 RGL-EPFL 的 .bsdf、MERL 的 .binary，或由点组成的文本，每行为 θi φi θo φo 及红绿蓝。",
    "{file!r} holds no value above 0: there is nothing to fit.":
        "{file!r} 中没有大于 0 的值：无可拟合。",
    "{file!r} holds spectra: take the file of the same material that ends in _rgb.bsdf.":
        "{file!r} 含有光谱：请使用同一材质以 _rgb.bsdf 结尾的文件。",
    "{file!r} holds values that are no numbers (NaN or infinite): download it again.":
        "{file!r} 含有非数值（NaN 或无穷大）：请重新下载。",
    "{file!r} is a Git LFS pointer, not the file itself: fetch it with git lfs pull.":
        "{file!r} 是 Git LFS 指针，而非文件本身：请用 git lfs pull 获取。",
    "{file!r} is a folder; name a file in it.":
        "{file!r} 是文件夹；请指定其中的文件。",
    "{file!r} is a web page, not a measurement: download the file that it links to.":
        "{file!r} 是网页而非测量数据：请下载它所链接的文件。",
    "{file!r} is anisotropic: it reflects otherwise when it is turned, which the fit does not know; take an isotropic material.":
        "{file!r} 是各向异性的：旋转后反射不同，拟合不支持；请使用各向同性的材质。",
    "{file!r} is being written already; remove {aside!r} if it is not.":
        "{file!r} 正在写入；若并非如此，请删除 {aside!r}。",
    "{file!r} is damaged or ends too early: download it again.":
        "{file!r} 已损坏或不完整：请重新下载。",
    "{file!r} is larger than half a gigabyte, which no measured BRDF is.":
        "{file!r} 大于半 GB，实测 BRDF 不会这么大。",
    "{file!r} is no BRDF of the RGL-EPFL database: it lacks some of its tables.":
        "{file!r} 不是 RGL-EPFL 数据库的 BRDF：缺少部分表格。",
    "{file!r} is protected or no ordinary file; name another.":
        "{file!r} 受保护或不是普通文件；请另指定一个。",
    "{file!r} names its values neither red, green and blue nor by wavelengths in nm that reach from 450 to 650.":
        "{file!r} 的数值既未标为红、绿、蓝，也未以覆盖 450 到 650 nm 的波长标注。",
    "{material} absorbs light, so it cannot be the medium outside; name a clear one, such as 'water', or its index, such as 1.33.":
        "{material} 会吸收光，不能作为外部介质；请给出透明的介质，例如 'water'，或其折射率，例如 1.33。",
    "{material} holds no measurement: bake a measured preset first.":
        "{material} 不含测量数据：请先烘焙一个测量预设。",
    "{material} is a library override, whose nodes and slots belong to another file: make it local first (Object, Relations, Make Local)":
        "{material} 是库重写，其节点与槽属于另一个文件：请先设为本地（物体，关系，设为本地）",
    "{material} is known by its reflectance in air alone: none in another medium follows; take data of n and k.":
        "{material} 只有在空气中的反射率：无法由此得出在其他介质中的反射率；请使用 n 和 k 的数据。",
    "{material} is linked from another file: make it local first (Object, Relations, Make Local)":
        "{material} 链接自另一个文件：请先设为本地（物体，关系，设为本地）",
    "{material} is no clear body: a common face is between two of them, such as water and glass.":
        "{material} 不是透明物体：公共面位于两个透明物体之间，例如水和玻璃。",
    "{material} is not a material of Facet & Film: make one with create_material() or Bake Spectral Preset.":
        "{material} 不是 Facet & Film 的材质：请用 create_material() 或“烘焙光谱预设”创建。",
    "{material} is not made of what a text says: name a material of another model.":
        "{material} 不是由文字描述构成的：请指定其他模型的材质。",
    "{model} takes no measurement: name one of its presets, or another model.":
        "{model} 不接受测量数据：请指定它的一个预设，或换一个模型。",
    "{name} is written by a bake, as JSON; leave it out, or as it is: not {value!r}.":
        "{name} 由烘焙以 JSON 写入；请省略或保持原样，而非 {value!r}。",
    "{name} must be a text, not {value!r}.":
        "{name} 必须是文本，而不是 {value!r}。",
    "{name} {value!r} is no colour: linear numbers go to {most}, and whole ones to 255 are sRGB.":
        "{name} {value!r} 不是颜色：线性数值最大为 {most}，255 以内的整数为 sRGB。",
    "{name} {value!r} is no colour; give three numbers, or one such as '#ffd98b'.":
        "{name} {value!r} 不是颜色；请给出三个数，或类似 '#ffd98b' 的值。",
    "{name} {value!r} is unknown; Valid: {valid}.":
        "未知{name} {value!r}；有效值：{valid}。",
    "{name} {value!r} is unknown; did you mean {near}? Valid: {valid}.":
        "未知{name} {value!r}；您是指 {near} 吗？有效值：{valid}。",
    "{preset} has no dataset of the database, so there is nothing to compare: its values are the preset's own. Name another preset, or a dataset such as 'main/Au/Babar'.":
        "{preset} 没有数据库中的数据集，因此无可比较：其数值为预设自有。请指定另一预设，或如 'main/Au/Babar' 的数据集。",
    "{preset} is a preset of {model}: leave the model out, or name that one.":
        "{preset} 是 {model} 的预设：请省略模型，或指定该模型。",
    "{preset} was not measured: it is a preset of {model}, which has no spectrum to bake. Make a material of it, or name a measured preset such as 'copper'.":
        "{preset} 没有测量数据：它是 {model} 的预设，没有可烘焙的光谱。请用它创建材质，或指定一个测量预设，例如 'copper'。",
    "{word!r} is measured from {low:g} to {high:g} nm, so hardly in the visible, 400 to 700 nm; choose "
    "another dataset.":
        "{word!r} 的测量范围为 {low:g} 到 {high:g} nm，几乎不含可见光 400 到 700 "
        "nm；请选择另一个数据集。",
    "{word!r} is outside of the stack and must not absorb, but has k up to {k:.2g}; name something clear, "
    "such as air or water.":
        "{word!r} 位于层堆外部，不得有吸收，但其 k 高达 {k:.2g}；请选择透明材料，如 air 或 water。",
    "{word!r} is unknown; did you mean {near}? A layer is of a dataset, a preset's material or an index such "
    "as 1.38.":
        "未知的 {word!r}；您是指 {near} 吗？层可以是数据集、预设的材料，或如 1.38 的折射率。",
}
