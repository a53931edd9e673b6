<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en_US">
<context>
    <name>AboutArm</name>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>unknown: the arm does not report it</source>
        <translation>未知：机械臂不提供</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件版本</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>Adapter</source>
        <translation>适配器</translation>
    </message>
    <message>
        <source>Serial number of the adapter</source>
        <translation>适配器序列号</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Identifiers of the feedback</source>
        <translation>反馈指令 ID</translation>
    </message>
    <message>
        <source>Identifiers of the commands</source>
        <translation>控制指令 ID</translation>
    </message>
    <message>
        <source>Frames received</source>
        <translation>接收报文</translation>
    </message>
    <message>
        <source>Online without interruption for</source>
        <translation>持续在线时间</translation>
    </message>
    <message>
        <source>Running time of the arm</source>
        <translation>机械臂运行时间</translation>
    </message>
    <message>
        <source>Joint {joint}</source>
        <translation>关节 {joint}</translation>
    </message>
    <message>
        <source>End</source>
        <translation>末端</translation>
    </message>
    <message>
        <source>Slip at a resume</source>
        <translation>解除急停时的滑移</translation>
    </message>
    <message>
        <source>Joint inspection</source>
        <translation>关节巡检</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>unknown: generation 1 does not report it</source>
        <translation>未知：第 1 代协议不提供</translation>
    </message>
    <message>
        <source>Generation {generation}</source>
        <translation>第 {generation} 代</translation>
    </message>
    <message>
        <source>none connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>none: simulated arm</source>
        <translation>无：仿真机械臂</translation>
    </message>
    <message>
        <source>none: not a CAN bus</source>
        <translation>无：不是 CAN 总线</translation>
    </message>
    <message>
        <source>{bitrate} bit/s, set by the operating system</source>
        <translation>{bitrate} bit/s，由操作系统设置</translation>
    </message>
    <message>
        <source>{bitrate} bit/s, set by this program</source>
        <translation>{bitrate} bit/s，由本程序设置</translation>
    </message>
    <message>
        <source>{ids}, not proven: the arm cannot be asked</source>
        <translation>{ids}，未证实：无法向机械臂查询</translation>
    </message>
    <message>
        <source>0x{first} to 0x{last} (offset 0x{offset})</source>
        <translation>0x{first} 至 0x{last}（偏移 0x{offset}）</translation>
    </message>
    <message>
        <source>{rate} per second</source>
        <translation>每秒 {rate} 帧</translation>
    </message>
    <message>
        <source>not heard</source>
        <translation>未收到</translation>
    </message>
    <message>
        <source>unknown: not read from the arm</source>
        <translation>未知：未从机械臂读取</translation>
    </message>
    <message>
        <source>{minimum}° to {maximum}°, at most {speed}°/s</source>
        <translation>{minimum}° 至 {maximum}°，最大 {speed}°/s</translation>
    </message>
    <message>
        <source>{limits} and {acceleration}°/s²</source>
        <translation>{limits}、{acceleration}°/s²</translation>
    </message>
    <message>
        <source>at most {linear} m/s and {angular} rad/s</source>
        <translation>最大 {linear} m/s、{angular} rad/s</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>{model}, as chosen; not checked yet</source>
        <translation>{model}（操作者选择，尚未核对）</translation>
    </message>
    <message>
        <source>{model}, confirmed by the pose it reports</source>
        <translation>{model}（与反馈位姿一致，已确认）</translation>
    </message>
    <message>
        <source>{model}, as chosen; other models fit its pose as well</source>
        <translation>{model}（操作者选择；其他型号也符合当前位姿）</translation>
    </message>
    <message>
        <source>{model}, as chosen; its pose is that of a {other}</source>
        <translation>{model}（操作者选择；但反馈位姿属于 {other}）</translation>
    </message>
    <message>
        <source>{model}, as chosen; its pose fits none of the models</source>
        <translation>{model}（操作者选择；反馈位姿不符合任何型号）</translation>
    </message>
    <message>
        <source>Date of the firmware</source>
        <translation>固件日期</translation>
    </message>
    <message>
        <source>Hardware</source>
        <translation>硬件</translation>
    </message>
    <message>
        <source>Node on the bus</source>
        <translation>总线节点</translation>
    </message>
    <message>
        <source>{type}, number {number}</source>
        <translation>{type}，编号 {number}</translation>
    </message>
    <message>
        <source>; joints 2 and 3 use the zeros from before S-V1.6-3</source>
        <translation>；关节 2、3 采用 S-V1.6-3 之前的零点</translation>
    </message>
    <message>
        <source>Reference of the joints</source>
        <translation>关节零位基准</translation>
    </message>
</context>
<context>
    <name>AboutArmDialog</name>
    <message>
        <source>About this arm</source>
        <translation>关于本机械臂</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>复制为文本</translation>
    </message>
    <message>
        <source>Joint inspection…</source>
        <translation>关节巡检…</translation>
    </message>
    <message>
        <source>Copied: paste it into a mail.</source>
        <translation>已复制，可粘贴到邮件中。</translation>
    </message>
</context>
<context>
    <name>AboutDialog</name>
    <message>
        <source>About armui</source>
        <translation>关于 armui</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>复制为文本</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>许可证</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>许可证全文</translation>
    </message>
    <message>
        <source>Licences of armui and of the libraries it comes with. Qt and PySide are under the LGPL 3: they are files of their own, and may be replaced.</source>
        <translation>armui 及其所带各库的许可证。Qt 和 PySide 采用 LGPL 3：它们是独立的文件，可以替换。</translation>
    </message>
    <message>
        <source>installed package</source>
        <translation>安装包</translation>
    </message>
    <message>
        <source>from the source or Python&apos;s packages</source>
        <translation>源码或 Python 软件包</translation>
    </message>
    <message>
        <source>No files of another version were taken over.</source>
        <translation>没有接管其他版本的文件。</translation>
    </message>
    <message>
        <source>an older version</source>
        <translation>旧版本</translation>
    </message>
    <message>
        <source>Files of {before} were taken over by {version} on {day}: settings {settings}, trajectories {trajectories}, logs {sessions}.</source>
        <translation>{version} 于 {day} 接管了 {before} 的文件：设置{settings}，轨迹 {trajectories} 个，日志 {sessions} 份。</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>有</translation>
    </message>
    <message>
        <source>no</source>
        <translation>无</translation>
    </message>
    <message>
        <source>The texts were not installed; they are in the release&apos;s zip file.</source>
        <translation>未安装许可证全文；见发布页的 zip 文件。</translation>
    </message>
    <message>
        <source>Copied: paste it into a mail.</source>
        <translation>已复制，可粘贴到邮件中。</translation>
    </message>
</context>
<context>
    <name>Action</name>
    <message>
        <source>Enable or disable all motors</source>
        <translation>全部电机使能或失能</translation>
    </message>
    <message>
        <source>Joint status</source>
        <translation>关节状态</translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation>回放日志</translation>
    </message>
    <message>
        <source>Export a log</source>
        <translation>导出日志</translation>
    </message>
    <message>
        <source>Back up, compare, restore parameters</source>
        <translation>参数备份、比较、恢复</translation>
    </message>
    <message>
        <source>Language: Chinese or English</source>
        <translation>语言：中文或英文</translation>
    </message>
    <message>
        <source>Theme: light or dark</source>
        <translation>主题：浅色或深色</translation>
    </message>
    <message>
        <source>Operator&apos;s view: only jog, run and stop</source>
        <translation>操作员视图：只有点动、运行和停止</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>使用帮助</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>退出程序</translation>
    </message>
    <message>
        <source>MOVE P: to the pose</source>
        <translation>MOVE P 运动到位姿</translation>
    </message>
    <message>
        <source>MOVE L: on a straight line to the pose</source>
        <translation>MOVE L 直线运动到位姿</translation>
    </message>
    <message>
        <source>MOVE C: along the arc</source>
        <translation>MOVE C 沿圆弧运动</translation>
    </message>
    <message>
        <source>Pause the planned motion</source>
        <translation>暂停规划轨迹</translation>
    </message>
    <message>
        <source>Continue the held motion</source>
        <translation>继续被保持的运动</translation>
    </message>
    <message>
        <source>Terminate the planned motion</source>
        <translation>终止规划轨迹</translation>
    </message>
    <message>
        <source>Target of</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Lamps of</source>
        <translation>灯光</translation>
    </message>
    <message>
        <source>Press Edit in the panel first.</source>
        <translation>请先在该面板中按“编辑”。</translation>
    </message>
    <message>
        <source>Only a simulated arm has them: connect one.</source>
        <translation>仅用于仿真机械臂：请先连接一台。</translation>
    </message>
    <message>
        <source>There is nothing to do here right now.</source>
        <translation>现在没有可执行的内容。</translation>
    </message>
    <message>
        <source>Folder of the logs</source>
        <translation>日志的文件夹</translation>
    </message>
    <message>
        <source>Model of the arm</source>
        <translation>机械臂型号</translation>
    </message>
    <message>
        <source>Tool trail: off</source>
        <translation>末端轨迹：关闭</translation>
    </message>
    <message>
        <source>Tool trail: last 5 s of motion</source>
        <translation>末端轨迹：最近 5 秒运动</translation>
    </message>
    <message>
        <source>Tool trail: last 15 s of motion</source>
        <translation>末端轨迹：最近 15 秒运动</translation>
    </message>
    <message>
        <source>Tool trail: last 60 s of motion</source>
        <translation>末端轨迹：最近 60 秒运动</translation>
    </message>
    <message>
        <source>Handles at the tool, along the axes of base or user frame</source>
        <translation>末端手柄：沿基坐标系或用户坐标系各轴</translation>
    </message>
    <message>
        <source>Handles at the tool, along its own axes</source>
        <translation>末端手柄：沿工具坐标轴</translation>
    </message>
    <message>
        <source>Handles at the joints</source>
        <translation>关节手柄</translation>
    </message>
    <message>
        <source>Park position: the measured angles</source>
        <translation>停放位：当前测得的角度</translation>
    </message>
    <message>
        <source>Park position: the targets</source>
        <translation>停放位：输入框中的目标</translation>
    </message>
    <message>
        <source>Leader arm (teaching input)</source>
        <translation>主臂（示教输入臂）</translation>
    </message>
    <message>
        <source>Follower arm (motion output)</source>
        <translation>从臂（运动输出臂）</translation>
    </message>
    <message>
        <source>Operator&apos;s view: hold Unlock to change this.</source>
        <translation>操作员视图：按住“解锁”后才能更改。</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
</context>
<context>
    <name>AdapterLine</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The system asks for the administrator&apos;s password…</source>
        <translation>系统正在询问管理员密码…</translation>
    </message>
    <message>
        <source>Cancelled. The system finishes what had begun.</source>
        <translation>已放弃。已经开始的操作由系统完成。</translation>
    </message>
    <message>
        <source>Under way…</source>
        <translation>正在执行…</translation>
    </message>
    <message>
        <source>The adapter is not the one that was shown: nothing was written.</source>
        <translation>适配器与所显示的不是同一个：没有写入任何文件。</translation>
    </message>
    <message>
        <source>Done; it takes effect at the next start of this computer.</source>
        <translation>已完成，下次启动电脑后生效。</translation>
    </message>
    <message>
        <source>Done; it takes effect when the adapter is plugged in again.</source>
        <translation>已完成，重新插入适配器后生效。</translation>
    </message>
    <message>
        <source>{channel} is switched on; listening whether anything is heard…</source>
        <translation>{channel} 已启用，正在监听是否收到报文…</translation>
    </message>
    <message>
        <source>{channel} is switched on, and {count} frames were heard.</source>
        <translation>{channel} 已启用，收到 {count} 个报文。</translation>
    </message>
    <message>
        <source>{channel} is switched on, but nothing is heard: is the arm powered, the CAN cable plugged in, the bit rate the arm&apos;s?</source>
        <translation>{channel} 已启用，但没有收到报文：机械臂是否上电、CAN 线是否插好、波特率是否与机械臂一致？</translation>
    </message>
    <message>
        <source>{channel} is switched off.</source>
        <translation>{channel} 已停用。</translation>
    </message>
    <message>
        <source>{channel}: nothing was found out. Run the diagnosis again.</source>
        <translation>{channel}：没有得到结果。请重新诊断。</translation>
    </message>
</context>
<context>
    <name>ArcBox</name>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中点</translation>
    </message>
    <message>
        <source>end</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>Captures the arm&apos;s present pose; nothing moves.</source>
        <translation>记录机械臂当前位姿，不会运动。</translation>
    </message>
    <message>
        <source>Moves to the captured start with MOVE P.</source>
        <translation>用 MOVE P 移到记录的起点。</translation>
    </message>
    <message>
        <source>MOVE C</source>
        <translation>MOVE C</translation>
    </message>
    <message>
        <source>Moves from the start through the middle to the end. Some firmware has no arcs.</source>
        <translation>从起点经中点运动到终点。部分固件不支持圆弧。</translation>
    </message>
    <message>
        <source>Capture start</source>
        <translation>记录起点</translation>
    </message>
    <message>
        <source>Capture middle</source>
        <translation>记录中点</translation>
    </message>
    <message>
        <source>Capture end</source>
        <translation>记录终点</translation>
    </message>
    <message>
        <source>Go to start</source>
        <translation>移到起点</translation>
    </message>
</context>
<context>
    <name>AreaTab</name>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Fills in the present tool pose; a plane&apos;s Z axis is that of the tool.</source>
        <translation>填入当前工具位姿；平面的 Z 轴就是工具的 Z 轴。</translation>
    </message>
    <message>
        <source>Add plane</source>
        <translation>添加平面</translation>
    </message>
    <message>
        <source>Planes and boxes of the work area</source>
        <translation>工作区的平面和长方体</translation>
    </message>
    <message>
        <source>Halt when others move it into the area</source>
        <translation>其他程序或手带入工作区时停住</translation>
    </message>
    <message>
        <source>Plane or box</source>
        <translation>平面或长方体</translation>
    </message>
    <message>
        <source>From tool</source>
        <translation>取自工具</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the plane or box</source>
        <translation>平面或长方体的名称</translation>
    </message>
    <message>
        <source>Deletes the chosen plane or box.</source>
        <translation>删除所选的平面或长方体。</translation>
    </message>
    <message>
        <source>Halt when a hand or another program enters</source>
        <translation>用手或由其他程序带入时停住机械臂</translation>
    </message>
    <message>
        <source>Box, edges</source>
        <translation>长方体边长</translation>
    </message>
    <message>
        <source>The arm stays out of the box; X to RZ are those of its centre.</source>
        <translation>机械臂不进入长方体；X 至 RZ 是其中心的位姿。</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Switch a plane or box</source>
        <translation>开关平面或长方体</translation>
    </message>
    <message>
        <source>The arm stays on the side to which the plane&apos;s Z axis points.</source>
        <translation>机械臂留在平面 Z 轴所指的一侧。</translation>
    </message>
    <message>
        <source>Delete a plane or box</source>
        <translation>删除平面或长方体</translation>
    </message>
    <message>
        <source>Choose a plane or a box above first.</source>
        <translation>请先在上方选择平面或长方体。</translation>
    </message>
    <message>
        <source>Add box</source>
        <translation>添加长方体</translation>
    </message>
    <message>
        <source>Off: it counts for nothing.</source>
        <translation>关闭后它不起作用。</translation>
    </message>
    <message>
        <source> (off)</source>
        <translation>（关闭）</translation>
    </message>
    <message>
        <source>Add a box to the work area</source>
        <translation>向工作区添加长方体</translation>
    </message>
    <message>
        <source>Apply the figures of the area</source>
        <translation>应用工作区的数值</translation>
    </message>
    <message>
        <source>Take the present tool pose</source>
        <translation>取当前工具位姿</translation>
    </message>
    <message>
        <source>Take the pose of a user frame</source>
        <translation>取用户坐标系的位姿</translation>
    </message>
    <message>
        <source>It is told in any case. A halt holds the arm where it is, powered.</source>
        <translation>无论如何都会提示。停住时机械臂原地保持，不断电。</translation>
    </message>
    <message>
        <source>below it</source>
        <translation>平面下方</translation>
    </message>
    <message>
        <source>above it</source>
        <translation>平面上方</translation>
    </message>
    <message>
        <source>beyond it, towards {axis} of the base</source>
        <translation>平面朝底座 {axis} 方向的一侧</translation>
    </message>
    <message>
        <source>Forbidden side of the plane: {side}</source>
        <translation>平面的禁区侧：{side}</translation>
    </message>
    <message>
        <source>It is off and counts for nothing. Switch it on to put it in force.</source>
        <translation>它已关闭，不起作用。打开后生效。</translation>
    </message>
    <message>
        <source>Type a name and a pose in the base. A plane keeps the arm on the side of its Z axis, a box keeps it out.</source>
        <translation>输入名称和在基坐标系中的位姿。平面使机械臂留在其 Z 轴一侧，长方体使其不进入。</translation>
    </message>
    <message>
        <source>Puts these figures in force, and the margin with them.</source>
        <translation>使这些数值连同余量生效。</translation>
    </message>
    <message>
        <source>The cell has no user frame yet.</source>
        <translation>单元还没有用户坐标系。</translation>
    </message>
    <message>
        <source>Fills in the pose of a user frame; its Z axis is that of the plane.</source>
        <translation>填入用户坐标系的位姿；它的 Z 轴就是平面的 Z 轴。</translation>
    </message>
    <message>
        <source>Nearest: {part}, {value} mm from “{name}”</source>
        <translation>最近：{part}，距“{name}” {value} mm</translation>
    </message>
    <message>
        <source>Press Apply to put the new figures in force.</source>
        <translation>请按“应用”使新数值生效。</translation>
    </message>
    <message>
        <source>From frame</source>
        <translation>取自坐标系</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Margin of the work area</source>
        <translation>工作区的余量</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开启</translation>
    </message>
    <message>
        <source>It is in force. Switch it off, or change its figures and press Apply.</source>
        <translation>它已生效。可以关闭，或更改数值后按“应用”。</translation>
    </message>
    <message>
        <source>Press Add plane or Add box: it holds for everything from then on.</source>
        <translation>请按“添加平面”或“添加长方体”：此后对一切运动有效。</translation>
    </message>
    <message>
        <source>Add a plane to the work area</source>
        <translation>向工作区添加平面</translation>
    </message>
    <message>
        <source>— (a new one)</source>
        <translation>—（新建）</translation>
    </message>
</context>
<context>
    <name>ArmKind</name>
    <message>
        <source>{model} (zeros before S-V1.6-3)</source>
        <translation>{model}（S-V1.6-3 之前的零点）</translation>
    </message>
</context>
<context>
    <name>ArmPart</name>
    <message>
        <source>the base</source>
        <translation>底座</translation>
    </message>
    <message>
        <source>the upper arm</source>
        <translation>大臂</translation>
    </message>
    <message>
        <source>the forearm</source>
        <translation>小臂</translation>
    </message>
    <message>
        <source>the wrist</source>
        <translation>手腕</translation>
    </message>
    <message>
        <source>the gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>the fourth link</source>
        <translation>第四连杆</translation>
    </message>
    <message>
        <source>the held object</source>
        <translation>所持物体</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>the shoulder</source>
        <translation>肩部</translation>
    </message>
</context>
<context>
    <name>ArmStatus</name>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>No solution</source>
        <translation>无解</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>奇异点</translation>
    </message>
    <message>
        <source>Target angle beyond limit</source>
        <translation>目标角度超过限</translation>
    </message>
    <message>
        <source>Joint communication fault</source>
        <translation>关节通信异常</translation>
    </message>
    <message>
        <source>Joint brake not released</source>
        <translation>关节抱闸未打开</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>机械臂发生碰撞</translation>
    </message>
    <message>
        <source>Overspeed in drag teaching</source>
        <translation>拖动示教时超速</translation>
    </message>
    <message>
        <source>Joint status fault</source>
        <translation>关节状态异常</translation>
    </message>
    <message>
        <source>Other fault</source>
        <translation>其它异常</translation>
    </message>
    <message>
        <source>Teaching: recording</source>
        <translation>示教记录</translation>
    </message>
    <message>
        <source>Teaching: replaying</source>
        <translation>示教执行</translation>
    </message>
    <message>
        <source>Teaching: paused</source>
        <translation>示教暂停</translation>
    </message>
    <message>
        <source>Main controller too hot</source>
        <translation>主控过温</translation>
    </message>
    <message>
        <source>Brake resistor too hot</source>
        <translation>释放电阻过温</translation>
    </message>
</context>
<context>
    <name>ArmView</name>
    <message>
        <source>Loading the 3D model …</source>
        <translation>正在加载 3D 模型…</translation>
    </message>
    <message>
        <source>Picture delayed</source>
        <translation>画面滞后</translation>
    </message>
    <message>
        <source>Restart the 3D view</source>
        <translation>重新启动 3D 视图</translation>
    </message>
    <message>
        <source>{point} in “{frame}”</source>
        <translation>{point}，“{frame}”坐标系</translation>
    </message>
    <message>
        <source>Restarting; the arm is not affected.</source>
        <translation>正在重新启动；机械臂不受影响。</translation>
    </message>
    <message>
        <source>It ended three times within a minute; the arm is not affected.</source>
        <translation>一分钟内结束了三次；机械臂不受影响。</translation>
    </message>
    <message>
        <source>Tool centre point</source>
        <translation>工具中心点</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>法兰</translation>
    </message>
</context>
<context>
    <name>Asker</name>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Jogging</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>恢复引导</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Other host</source>
        <translation>其他程序</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>客户端</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>本程序</translation>
    </message>
</context>
<context>
    <name>AxisRows</name>
    <message>
        <source>Share of the speed in the top bar; a fifth of it without the trigger</source>
        <translation>顶栏速度的百分比；不扣扳机时为其五分之一</translation>
    </message>
</context>
<context>
    <name>BackupColumn</name>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>In the arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
</context>
<context>
    <name>BackupDialog</name>
    <message>
        <source>Parameter backup</source>
        <translation>参数备份</translation>
    </message>
    <message>
        <source>Parameters in the file and in the arm</source>
        <translation>文件与机械臂中的参数</translation>
    </message>
    <message>
        <source>Only differences</source>
        <translation>只看不同</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>全不选</translation>
    </message>
    <message>
        <source>Save to a file…</source>
        <translation>保存到文件…</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Reading was stopped; what was read is shown.</source>
        <translation>已停止读取；显示的是已读到的参数。</translation>
    </message>
    <message>
        <source>Save the parameters of the arm</source>
        <translation>保存机械臂参数</translation>
    </message>
    <message>
        <source>Saved {count} parameters to {path}.</source>
        <translation>已将 {count} 个参数保存到 {path}。</translation>
    </message>
    <message>
        <source>{missing} could not be read from the arm and are not in the file.</source>
        <translation>有 {missing} 个参数未能从机械臂读出，文件中没有。</translation>
    </message>
    <message>
        <source>Open a parameter backup</source>
        <translation>打开参数备份</translation>
    </message>
    <message>
        <source>The file is from an arm of protocol generation {filed}, this one speaks generation {here}. Parameters that both have can be restored; their resolution differs.</source>
        <translation>文件来自第 {filed} 代协议的机械臂，当前机械臂为第 {here} 代。两者都有的参数可以恢复；数值的分辨率不同。</translation>
    </message>
    <message>
        <source>The file is from firmware {filed}, this arm has {here}. Check the values before you restore them.</source>
        <translation>文件来自固件 {filed}，当前机械臂的固件为 {here}。恢复前请核对数值。</translation>
    </message>
    <message>
        <source>Restore parameters</source>
        <translation>恢复参数</translation>
    </message>
    <message>
        <source>{count} parameters of the arm will be set to the values in the file, limits and collision levels included if they are ticked. Each is read back and compared.</source>
        <translation>将把机械臂的 {count} 个参数设为文件中的值；如已选中，限位和碰撞等级也会改变。每个参数都会回读并比较。</translation>
    </message>
    <message>
        <source>{failed} of {count} parameters were not restored.</source>
        <translation>{count} 个参数中有 {failed} 个未恢复。</translation>
    </message>
    <message>
        <source>No file is open; the arm&apos;s own values are shown.</source>
        <translation>未打开文件；显示的是机械臂当前的值。</translation>
    </message>
    <message>
        <source>Restored {count} parameters; reading them back gave the same values.</source>
        <translation>已恢复 {count} 个参数，回读数值一致。</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>停止读取</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Open a file first.</source>
        <translation>请先打开文件。</translation>
    </message>
    <message>
        <source>Tick what differs in the table first.</source>
        <translation>请先在表中勾选不同的参数。</translation>
    </message>
    <message>
        <source>{name}: saved {time}, {model}, {device}, generation {generation}, {firmware}</source>
        <translation>{name}：保存于 {time}，{model}，{device}，第 {generation} 代，{firmware}</translation>
    </message>
    <message>
        <source>The file is from a {filed}, this arm is a {here}: the limits of one may be wrong for the other. Check the values before you restore them.</source>
        <translation>该文件来自 {filed}，当前机械臂为 {here}：两种型号的限位可能不通用。恢复前请核对数值。</translation>
    </message>
</context>
<context>
    <name>BackupModel</name>
    <message>
        <source>… reading</source>
        <translation>… 读取中</translation>
    </message>
    <message>
        <source>… restoring</source>
        <translation>… 恢复中</translation>
    </message>
    <message>
        <source>✓ restored</source>
        <translation>✓ 已恢复</translation>
    </message>
    <message>
        <source>✗ not restored</source>
        <translation>✗ 未恢复</translation>
    </message>
    <message>
        <source>≠ cannot be restored</source>
        <translation>≠ 无法恢复</translation>
    </message>
</context>
<context>
    <name>BaseTab</name>
    <message>
        <source>Place of the base in the room</source>
        <translation>底座在房间中的位置</translation>
    </message>
    <message>
        <source>Apply the place of the base</source>
        <translation>应用底座的位置</translation>
    </message>
    <message>
        <source>Nothing is changed.</source>
        <translation>没有改动。</translation>
    </message>
    <message>
        <source>Stands the arm in the room: for the picture, the floor and the frame WORLD.</source>
        <translation>按此把机械臂放进房间：用于画面、地面检查和 WORLD 坐标系。</translation>
    </message>
    <message>
        <source>Press Apply: the floor is then where the room has it.</source>
        <translation>按“应用”：之后地面以房间的为准。</translation>
    </message>
    <message>
        <source>All 0: the arm stands upright on the floor. Type where its base stands.</source>
        <translation>全为 0：机械臂正立于地面。请输入底座在房间中的位置。</translation>
    </message>
    <message>
        <source>The arm stands so. The frame “{name}” shows poses in the room.</source>
        <translation>机械臂已按此放置。用坐标系“{name}”可显示房间中的位姿。</translation>
    </message>
    <message>
        <source>The base in the room (mm, °)</source>
        <translation>底座在房间中的位姿（mm，°）</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>The room&apos;s Z points up, its floor is at Z 0. Areas, frames and targets stay given in the base. A table that the arm stands on belongs in the area: the floor check asks only for the floor.</source>
        <translation>房间的 Z 轴朝上，地面为 Z 0。区域、坐标系和目标仍以基座给出。机械臂所立的桌子请加入区域：地面检查只看地面。</translation>
    </message>
</context>
<context>
    <name>BinDialog</name>
    <message>
        <source>Choose what to restore</source>
        <translation>请选择要恢复的轨迹</translation>
    </message>
    <message>
        <source>Deleted trajectories can be restored for {days} days. If a name has been taken meanwhile, a number is added.</source>
        <translation>删除的轨迹在 {days} 天内可以恢复。如果名称已被占用，恢复后会加上编号。</translation>
    </message>
    <message>
        <source>Nothing has been deleted in the last {days} days.</source>
        <translation>最近 {days} 天内没有删除过轨迹。</translation>
    </message>
    <message>
        <source>Recently deleted</source>
        <translation>最近删除</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Deleted</source>
        <translation>删除时间</translation>
    </message>
    <message>
        <source>Kept until</source>
        <translation>保留至</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
</context>
<context>
    <name>BusError</name>
    <message>
        <source>a frame could not be sent in time</source>
        <translation>有一帧未能及时发出</translation>
    </message>
    <message>
        <source>arbitration lost: a frame of higher priority went first, which is normal</source>
        <translation>仲裁失败：优先级更高的帧先发出，属正常现象</translation>
    </message>
    <message>
        <source>the adapter&apos;s CAN controller reports</source>
        <translation>适配器的 CAN 控制器有报告</translation>
    </message>
    <message>
        <source>the adapter has lost frames: too slow for this bus, or its USB port is</source>
        <translation>适配器丢失了帧：适配器或其 USB 接口跟不上这条总线</translation>
    </message>
    <message>
        <source>the adapter has lost frames to be sent</source>
        <translation>适配器丢失了待发送的帧</translation>
    </message>
    <message>
        <source>many errors: check the cable and both terminating resistors (120 Ω)</source>
        <translation>错误较多：请检查线缆和两端 120 Ω 终端电阻</translation>
    </message>
    <message>
        <source>error passive: check CAN_H and CAN_L, both terminating resistors and the bit rate</source>
        <translation>错误被动：请检查 CAN_H、CAN_L、两端终端电阻和波特率</translation>
    </message>
    <message>
        <source>there are few errors again</source>
        <translation>错误已减少</translation>
    </message>
    <message>
        <source>disturbed frame: check the cable, its shield, and the bit rate</source>
        <translation>帧受到干扰：请检查线缆、屏蔽层和波特率</translation>
    </message>
    <message>
        <source>transceiver: check CAN_H and CAN_L for a short or an open line</source>
        <translation>收发器：请检查 CAN_H、CAN_L 是否短路或断路</translation>
    </message>
    <message>
        <source>nobody acknowledges: check the arm&apos;s power, the cable and the bit rate</source>
        <translation>无人应答：请检查机械臂电源、线缆和波特率</translation>
    </message>
    <message>
        <source>bus off: too many errors, the adapter has left the bus. Check the cable, both terminating resistors (120 Ω) and the bit rate, then connect again</source>
        <translation>总线关闭（bus off）：错误过多，适配器已退出总线。请检查线缆、两端 120 Ω 终端电阻和波特率，然后重新连接</translation>
    </message>
    <message>
        <source>error on the bus: check the cable</source>
        <translation>总线错误：请检查线缆</translation>
    </message>
    <message>
        <source>the adapter has rejoined the bus</source>
        <translation>适配器已重新加入总线</translation>
    </message>
    <message>
        <source>the adapter gives no further details</source>
        <translation>适配器未给出更多信息</translation>
    </message>
</context>
<context>
    <name>BusMonitor</name>
    <message>
        <source>silent</source>
        <translation>已静默</translation>
    </message>
    <message>
        <source>Show as curve</source>
        <translation>显示为曲线</translation>
    </message>
</context>
<context>
    <name>BusPage</name>
    <message>
        <source>Counted since {time}, when opened or cleared: {count} frames</source>
        <translation>自 {time}（打开或清空）起统计：{count} 帧</translation>
    </message>
    <message>
        <source>Paused: the figures are those of {time}</source>
        <translation>已暂停：显示的是 {time} 的数值</translation>
    </message>
    <message>
        <source>Generation not known yet: read as generation 2.</source>
        <translation>协议代次未知：暂按第 2 代解读。</translation>
    </message>
    <message>
        <source>Show as curve</source>
        <translation>显示为曲线</translation>
    </message>
    <message>
        <source>Show this identifier alone</source>
        <translation>只显示该 ID</translation>
    </message>
    <message>
        <source>Copy {frame}</source>
        <translation>复制 {frame}</translation>
    </message>
    <message>
        <source>Copy to the send fields</source>
        <translation>填入发送栏</translation>
    </message>
    <message>
        <source>Bus monitor</source>
        <translation>总线监视</translation>
    </message>
    <message>
        <source>Frames by identifier</source>
        <translation>按 ID 排列的帧</translation>
    </message>
    <message>
        <source>Frames in order of time</source>
        <translation>按时间排列的帧</translation>
    </message>
</context>
<context>
    <name>BusSummary</name>
    <message>
        <source>{count} frames were lost before the program could read them: the computer is too busy, or the adapter too slow. What is shown is not all that was on the bus.</source>
        <translation>有 {count} 帧在程序读取前丢失：电脑过于繁忙，或适配器太慢。这里显示的不是总线上的全部帧。</translation>
    </message>
    <message>
        <source>The bus is nearly full: frames of low priority come late. Send less.</source>
        <translation>总线接近满载：优先级低的帧会延迟。请减少发送量。</translation>
    </message>
    <message>
        <source>Not counted here: {late} frames that came while the window was held up, {more} of identifiers beyond the first {rows}.</source>
        <translation>未计入：窗口受阻期间到达的 {late} 帧，以及超出前 {rows} 个 ID 的 {more} 帧。</translation>
    </message>
    <message>
        <source>Bus load</source>
        <translation>总线负载</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误帧</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>丢失帧</translation>
    </message>
    <message>
        <source>Of the bit rate, stuff bits not counted; right button: show as curve</source>
        <translation>占波特率的比例，不计填充位；右键可显示为曲线</translation>
    </message>
    <message>
        <source>Per second, this program&apos;s included</source>
        <translation>每秒帧数，包括本程序发送的帧</translation>
    </message>
    <message>
        <source>Errors on the bus that the adapter has reported since the counting began</source>
        <translation>开始统计以来适配器报告的总线错误</translation>
    </message>
    <message>
        <source>Lost by the system&apos;s queue or by the adapter since the counting began</source>
        <translation>开始统计以来被系统队列或适配器丢失的帧</translation>
    </message>
</context>
<context>
    <name>ButtonRows</name>
    <message>
        <source>Pressed: {buttons}</source>
        <translation>按下：{buttons}</translation>
    </message>
    <message>
        <source>No button</source>
        <translation>不分配</translation>
    </message>
    <message>
        <source>The buttons as delivered</source>
        <translation>恢复为初始的按键分配</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复默认</translation>
    </message>
</context>
<context>
    <name>CartesianPanel</name>
    <message>
        <source>Frame of the figures</source>
        <translation>数值所用坐标系</translation>
    </message>
    <message>
        <source>in the base frame</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>in “{name}”</source>
        <translation>坐标系“{name}”</translation>
    </message>
    <message>
        <source>Fills the fields with the measured pose; nothing moves.</source>
        <translation>把当前位姿填入输入框，不会运动。</translation>
    </message>
    <message>
        <source>MOVE P</source>
        <translation>MOVE P</translation>
    </message>
    <message>
        <source>Moves to the pose, each joint on its own path.</source>
        <translation>移到该位姿，各关节各自运动。</translation>
    </message>
    <message>
        <source>MOVE L</source>
        <translation>MOVE L</translation>
    </message>
    <message>
        <source>Moves to the pose on a straight line.</source>
        <translation>沿直线移到该位姿。</translation>
    </message>
    <message>
        <source>Tool centre point</source>
        <translation>工具中心点</translation>
    </message>
    <message>
        <source>Flange (no tool set)</source>
        <translation>法兰（未设置工具）</translation>
    </message>
    <message>
        <source>Cartesian</source>
        <translation>末端控制</translation>
    </message>
    <message>
        <source>Take current</source>
        <translation>装载</translation>
    </message>
</context>
<context>
    <name>CellPanel</name>
    <message>
        <source>Reads a cell from a file; says what is different before it takes effect.</source>
        <translation>从文件读取单元；生效之前说明有何不同。</translation>
    </message>
    <message>
        <source>Asks first, then deletes the cell and its file.</source>
        <translation>先询问，再删除单元及其文件。</translation>
    </message>
    <message>
        <source>Manage</source>
        <translation>管理</translation>
    </message>
    <message>
        <source>Unfolds what is done with cells: new, rename, import, export, compare, delete.</source>
        <translation>展开单元的管理：新建、改名、导入、导出、比较、删除。</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Unfolds the jog buttons: poses are taken without leaving the page.</source>
        <translation>展开点动按钮：采集位姿无需离开本页。</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>In what it differs from “{name}”:</source>
        <translation>与“{name}”的不同：</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>… and {count} more</source>
        <translation>……另有 {count} 处</translation>
    </message>
    <message>
        <source>Says how another cell of the list differs from the one in force.</source>
        <translation>说明列表中另一个单元与生效的单元有何不同。</translation>
    </message>
    <message>
        <source>Writes the cell to a file of its own.</source>
        <translation>把单元写到单独的文件。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>改名</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Puts another cell in force, or none; that confirms it, too.</source>
        <translation>换用另一个单元或不用单元；同时也就确认了它。</translation>
    </message>
    <message>
        <source>“{name}” with everything in it is deleted, and no cell is in force then. Export it first if it may be wanted again.</source>
        <translation>“{name}”及其全部内容将被删除，之后没有生效的单元。以后可能还要用的，请先导出。</translation>
    </message>
    <message>
        <source>— (no cell)</source>
        <translation>—（无单元）</translation>
    </message>
    <message>
        <source>They are the same.</source>
        <translation>两者相同。</translation>
    </message>
    <message>
        <source>Confirm cell</source>
        <translation>确认单元</translation>
    </message>
    <message>
        <source>Compare the cell with another</source>
        <translation>与另一个单元比较</translation>
    </message>
    <message>
        <source>Manage the cells</source>
        <translation>管理单元</translation>
    </message>
    <message>
        <source>Jog beside the cell</source>
        <translation>在单元页点动</translation>
    </message>
    <message>
        <source>Compare with “{name}”</source>
        <translation>与“{name}”比较</translation>
    </message>
    <message>
        <source>Choose it</source>
        <translation>选用它</translation>
    </message>
    <message>
        <source>It takes the place of the file of this name that could not be read, which is put aside. What it holds:</source>
        <translation>它将取代同名但无法读取的文件，该文件另行保存。其内容：</translation>
    </message>
    <message>
        <source>Import the cell “{name}”</source>
        <translation>导入单元“{name}”</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Type a name first.</source>
        <translation>请先输入名称。</translation>
    </message>
    <message>
        <source>Gives the cell in force and its file the name that is typed.</source>
        <translation>用输入的名称给生效的单元及其文件改名。</translation>
    </message>
    <message>
        <source>There is no other cell.</source>
        <translation>没有其他单元。</translation>
    </message>
    <message>
        <source>Cell&apos;s name</source>
        <translation>单元名称</translation>
    </message>
    <message>
        <source>Chosen cell</source>
        <translation>所选单元</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>Export the cell</source>
        <translation>导出单元</translation>
    </message>
    <message>
        <source>Import a cell</source>
        <translation>导入单元</translation>
    </message>
    <message>
        <source>Nothing is to be confirmed: the cell is in force, or there is none.</source>
        <translation>没有需要确认的：单元已生效，或没有单元。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>It takes the place of the cell of this name. What changes:</source>
        <translation>它将取代同名的单元。改变的内容：</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>What it holds:</source>
        <translation>它的内容：</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Makes an empty cell; a tool typed before becomes its first.</source>
        <translation>新建一个空单元；先前输入的工具成为它的第一个工具。</translation>
    </message>
    <message>
        <source>Delete the cell</source>
        <translation>删除单元</translation>
    </message>
    <message>
        <source>The cell shown is that of the arm in front of you; it takes effect.</source>
        <translation>所示单元就是面前这台机械臂的；确认后生效。</translation>
    </message>
    <message>
        <source>New cell</source>
        <translation>新建单元</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>工件</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>底座</translation>
    </message>
</context>
<context>
    <name>CellTab</name>
    <message>
        <source>Not in force until the cell is confirmed; the picture shows it pale.</source>
        <translation>确认单元之前不生效；画面中以淡色线框显示。</translation>
    </message>
</context>
<context>
    <name>ClientQuestion</name>
    <message>
        <source>It is the program “{program}”, process {process}, run by you.</source>
        <translation>来自您的程序“{program}”（进程 {process}）。</translation>
    </message>
    <message>
        <source>Refused by itself in {seconds} s.</source>
        <translation>{seconds} s 后自动拒绝。</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>拒绝</translation>
    </message>
</context>
<context>
    <name>CloseButton</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>CloseQuestion</name>
    <message>
        <source>The arm is moving</source>
        <translation>机械臂正在运动</translation>
    </message>
    <message>
        <source>If you end the motion, the arm comes to rest where it is; its motors stay enabled. If you let it finish, it goes on to its target, and this program can no longer stop it. Press the emergency stop if it must not move.</source>
        <translation>结束运动：机械臂在当前位置停下，电机保持使能。任其完成：机械臂继续运动到目标位置，本程序将无法再停止它。如果机械臂不得运动，请按急停。</translation>
    </message>
    <message>
        <source>End the motion and close</source>
        <translation>结束运动并关闭</translation>
    </message>
    <message>
        <source>Let it finish and close</source>
        <translation>任其完成并关闭</translation>
    </message>
</context>
<context>
    <name>CollisionPanel</name>
    <message>
        <source>Collision level</source>
        <translation>碰撞等级</translation>
    </message>
    <message>
        <source>Levels 1 to 8 watch for collisions; level 0 does not watch at all. The maker has not published whether 1 or 8 is the more sensitive one.</source>
        <translation>1–8 级检测碰撞，0 级不检测。厂家未公布 1 级与 8 级哪个更灵敏。</translation>
    </message>
    <message>
        <source>Level 0 – no collision detection: {joints} will not stop after hitting something or someone.</source>
        <translation>等级 0 – 不检测碰撞：{joints} 碰到物体或人时不会停止。</translation>
    </message>
    <message>
        <source>This switches the collision detection of {joints} off: the arm will not stop after hitting something or someone. Keep everyone out of its reach.</source>
        <translation>将关闭 {joints} 的碰撞检测：碰到物体或人时机械臂不会停止。请确保工作范围内无人。</translation>
    </message>
    <message>
        <source>no detection</source>
        <translation>不检测</translation>
    </message>
</context>
<context>
    <name>ColorDialog</name>
    <message>
        <source>Colour of the lamps</source>
        <translation>灯光颜色</translation>
    </message>
</context>
<context>
    <name>ColumnPicker</name>
    <message>
        <source>Guess: check it</source>
        <translation>推测值，请核对</translation>
    </message>
    <message>
        <source>Column {number}</source>
        <translation>第 {number} 列</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>间隔时间</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Ignored</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>{column}: quantity</source>
        <translation>{column}：含义</translation>
    </message>
    <message>
        <source>{column}: unit</source>
        <translation>{column}：单位</translation>
    </message>
</context>
<context>
    <name>ColumnsOffer</name>
    <message>
        <source>Import by columns…</source>
        <translation>按列导入…</translation>
    </message>
</context>
<context>
    <name>ColumnsPage</name>
    <message>
        <source>Importing {count} rows…</source>
        <translation>正在导入 {count} 行…</translation>
    </message>
    <message>
        <source>Not imported. {reason}</source>
        <translation>未导入。{reason}</translation>
    </message>
    <message>
        <source>Cancelling the import…</source>
        <translation>正在取消导入…</translation>
    </message>
    <message>
        <source>Import by columns</source>
        <translation>按列导入</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Import as</source>
        <translation>导入为</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制轨迹</translation>
    </message>
    <message>
        <source>Points, {move}</source>
        <translation>轨迹点，{move}</translation>
    </message>
    <message>
        <source>Poses of</source>
        <translation>位姿属于</translation>
    </message>
    <message>
        <source>Frame of the poses</source>
        <translation>位姿的坐标系</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>For points whose speed is in no column</source>
        <translation>用于未由列给出速度的轨迹点</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>{file}: {count} columns, {rows} rows; the first rows are shown</source>
        <translation>{file}：{count} 列，{rows} 行；下面显示前几行</translation>
    </message>
    <message>
        <source>; {count} further columns are left out</source>
        <translation>；另有 {count} 列未显示</translation>
    </message>
    <message>
        <source>Columns {columns} may be radians or degrees: choose which.</source>
        <translation>第 {columns} 列可能是弧度，也可能是度：请选择。</translation>
    </message>
    <message>
        <source>the tool “{name}”</source>
        <translation>工具“{name}”</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>the flange</source>
        <translation>法兰</translation>
    </message>
    <message>
        <source>in the base frame</source>
        <translation>在基坐标系中</translation>
    </message>
    <message>
        <source>in “{name}”</source>
        <translation>在“{name}”中</translation>
    </message>
    <message>
        <source>Columns {columns} may be normalised figures (−100 to 100), or another robot&apos;s: convert those to degrees first. If they are degrees, say so.</source>
        <translation>第 {columns} 列可能是归一化数值（−100 到 100），或来自其他机器人：请先换算为度。若确实是度，请予以确认。</translation>
    </message>
    <message>
        <source>Columns {columns} may be in {units}: choose which.</source>
        <translation>第 {columns} 列的单位可能是 {units}：请选择。</translation>
    </message>
    <message>
        <source>Columns {columns} may be another robot&apos;s, or in another unit: convert those to degrees first. If they are degrees, say so.</source>
        <translation>第 {columns} 列可能来自其他机器人，或为其他单位：请先换算为度。若确实是度，请予以确认。</translation>
    </message>
    <message>
        <source>Column {number} holds {value}; {joint} turns from {low} to {high}.</source>
        <translation>第 {number} 列中有 {value}，而 {joint} 的转动范围为 {low} 至 {high}。</translation>
    </message>
    <message>
        <source>Or choose “{choice}” under “{becomes}”: the columns suffice for that.</source>
        <translation>或把“{becomes}”改为“{choice}”：现有的列已足够。</translation>
    </message>
    <message>
        <source>What is needed depends on “{becomes}”.</source>
        <translation>需要哪些列取决于“{becomes}”。</translation>
    </message>
    <message>
        <source>The angles are in different units: {columns}. Check that this is meant.</source>
        <translation>各角度的单位不同：{columns}。请确认无误。</translation>
    </message>
    <message>
        <source>Radians</source>
        <translation>弧度</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>度</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>%(prog)s: error: %(message)s
</source>
        <translation>%(prog)s：错误：%(message)s
</translation>
    </message>
    <message>
        <source>argument %(argument_name)s: %(message)s</source>
        <translation>参数 %(argument_name)s：%(message)s</translation>
    </message>
    <message>
        <source>ambiguous option: %(option)s could match %(matches)s</source>
        <translation>选项不明确：%(option)s 可能是 %(matches)s</translation>
    </message>
    <message>
        <source>expected at least one argument</source>
        <translation>至少需要一个值</translation>
    </message>
    <message>
        <source>expected at most one argument</source>
        <translation>最多只能有一个值</translation>
    </message>
    <message>
        <source>expected one argument</source>
        <translation>需要一个值</translation>
    </message>
    <message>
        <source>ignored explicit argument %r</source>
        <translation>多余的值 %r</translation>
    </message>
    <message>
        <source>invalid %(type)s value: %(value)r</source>
        <translation>不是有效的 %(type)s 值：%(value)r</translation>
    </message>
    <message>
        <source>invalid choice: %(value)r (choose from %(choices)s)</source>
        <translation>无效的选择：%(value)r（可选 %(choices)s）</translation>
    </message>
    <message>
        <source>not allowed with argument %s</source>
        <translation>不能与参数 %s 同时使用</translation>
    </message>
    <message>
        <source>the following arguments are required: %s</source>
        <translation>缺少以下参数：%s</translation>
    </message>
    <message>
        <source>unrecognized arguments: %s</source>
        <translation>无法识别的参数：%s</translation>
    </message>
    <message>
        <source>commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>print a recorded CAN log frame by frame, in words and units</source>
        <translation>逐帧显示录制的 CAN 日志，带文字和单位</translation>
    </message>
    <message>
        <source>say what is wrong with this computer, the bus and the arm</source>
        <translation>诊断本机、总线和机械臂的问题</translation>
    </message>
    <message>
        <source>write a recorded CAN log as MCAP, CSV or Parquet</source>
        <translation>将录制的 CAN 日志导出为 MCAP、CSV 或 Parquet</translation>
    </message>
    <message>
        <source>record what is on a bus to files, without a window</source>
        <translation>不开窗口，将总线上的内容录制到文件</translation>
    </message>
    <message>
        <source>run the simulated arm on a CAN bus until Ctrl-C</source>
        <translation>在 CAN 总线上运行仿真机械臂，直到 Ctrl-C</translation>
    </message>
    <message>
        <source>show a recorded CAN log in the window, as if it were live</source>
        <translation>在窗口中像实时一样回放录制的 CAN 日志</translation>
    </message>
    <message>
        <source>armui COMMAND --help tells more of one.</source>
        <translation>armui COMMAND --help 显示某个命令的详细说明。</translation>
    </message>
    <message>
        <source>positional arguments</source>
        <translation>位置参数</translation>
    </message>
    <message>
        <source>options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>show this help message and exit</source>
        <translation>显示本帮助并退出</translation>
    </message>
    <message>
        <source>log: .log (candump -L) and whatever else python-can reads (.log, .asc, .blf, .trc, .csv, .db, .txt), also with .gz</source>
        <translation>日志：.log（candump -L）及 python-can 能读的其他格式（.log, .asc, .blf, .trc, .csv, .db, .txt），也可带 .gz</translation>
    </message>
    <message>
        <source>Exit code: 0 an arm answers, 1 none does, 2 the file of --report was not written.</source>
        <translation>退出码：0 有机械臂应答；1 没有应答；2 --report 的文件未写入。</translation>
    </message>
    <message>
        <source>keep what was found in a zip file, too, with log, settings and versions, to be sent to whoever helps; an existing file is left as it is</source>
        <translation>同时将结果连同日志、设置和版本存入一个 zip 文件，以便发给提供帮助的人；已有文件不会被覆盖</translation>
    </message>
    <message>
        <source>Export a recorded CAN log: MCAP with ROS 2 messages, a table as CSV or Parquet, or every frame as a CSV file for each message; its episodes as a dataset of LeRobot.</source>
        <translation>导出录制的 CAN 日志：含 ROS 2 消息的 MCAP、CSV 或 Parquet 表格、每种消息一个 CSV 文件，或把其中的片段导出为 LeRobot 数据集。</translation>
    </message>
    <message>
        <source>of the files (blf)</source>
        <translation>文件格式（blf）</translation>
    </message>
    <message>
        <source>faults (--fault)</source>
        <translation>故障（--fault）</translation>
    </message>
    <message>
        <source>the controller loses the connection to a joint (VALUE: joint)</source>
        <translation>控制器与某关节失去通信（VALUE：关节）</translation>
    </message>
    <message>
        <source>a motor is too hot (VALUE: joint)</source>
        <translation>电机过热（VALUE：关节）</translation>
    </message>
    <message>
        <source>a driver is too hot (VALUE: joint)</source>
        <translation>驱动器过热（VALUE：关节）</translation>
    </message>
    <message>
        <source>the supply gives 18 V</source>
        <translation>供电电压为 18 V</translation>
    </message>
    <message>
        <source>a driver sees too much current and switches its motor off (VALUE: joint)</source>
        <translation>驱动器过流并断开其电机（VALUE：关节）</translation>
    </message>
    <message>
        <source>a joint&apos;s encoder fails (VALUE: joint)</source>
        <translation>关节编码器故障（VALUE：关节）</translation>
    </message>
    <message>
        <source>a driver fails and switches its motor off (VALUE: joint)</source>
        <translation>驱动器故障并断开其电机（VALUE：关节）</translation>
    </message>
    <message>
        <source>something keeps a joint from turning (VALUE: joint)</source>
        <translation>关节被卡住，无法转动（VALUE：关节）</translation>
    </message>
    <message>
        <source>something pushes at a joint with 40 N·m (VALUE: joint)</source>
        <translation>关节受到 40 N·m 的外力（VALUE：关节）</translation>
    </message>
    <message>
        <source>a joint&apos;s limits read 0xFFFF until they are reset; does not mend by itself (VALUE: joint)</source>
        <translation>关节限位读数为 0xFFFF，直到重新设置；不会自行恢复（VALUE：关节）</translation>
    </message>
    <message>
        <source>the arm answers but no longer tells how it is</source>
        <translation>机械臂有应答，但不再反馈状态</translation>
    </message>
    <message>
        <source>the controller neither hears nor says anything</source>
        <translation>控制器既不接收也不发送</translation>
    </message>
    <message>
        <source>frames of any identifier and content on the bus (VALUE: frames a second)</source>
        <translation>总线上出现任意标识符和内容的帧（VALUE：每秒帧数）</translation>
    </message>
    <message>
        <source>frames get lost, both ways (VALUE: share of the frames)</source>
        <translation>双向丢帧（VALUE：丢帧比例）</translation>
    </message>
    <message>
        <source>frames arrive later, both ways (VALUE: seconds)</source>
        <translation>双向延迟（VALUE：秒）</translation>
    </message>
    <message>
        <source>bugs (--bugs)</source>
        <translation>固件缺陷（--bugs）</translation>
    </message>
    <message>
        <source>angles and pose read 0 until the teaching handle is set with 0x47D</source>
        <translation>用 0x47D 设置示教手柄之前，角度和位姿读数为 0</translation>
    </message>
    <message>
        <source>made a teaching input with 0x470, the arm says nothing more until a power cycle</source>
        <translation>用 0x470 设为示教输入臂后，机械臂不再发送任何内容，直到重新上电</translation>
    </message>
    <message>
        <source>leaving drag teaching drops the arm; the simulated arm does so with every version</source>
        <translation>退出拖动示教时机械臂下落；仿真机械臂在所有版本中都如此</translation>
    </message>
    <message>
        <source>a mode word that leaves MIT or high-follow is not followed by any motion until a reset, and moves the zero of joint 1 by 12°</source>
        <translation>退出 MIT 或高跟随的模式指令之后不再运动，直到复位；并使 1 号关节零位偏移 12°</translation>
    </message>
    <message>
        <source>30 s after it was switched on the arm makes itself a teaching input</source>
        <translation>上电 30 s 后机械臂自行变为示教输入臂</translation>
    </message>
    <message>
        <source>all limits read -0.1°/-0.1° and 0xFFFF as acceleration until they are reset</source>
        <translation>所有限位读数为 -0.1°/-0.1°，加速度读数为 0xFFFF，直到重新设置</translation>
    </message>
    <message>
        <source>10 s after all motors are on, joint 3 goes on at 2°/s for 30° and its feedback does not show it; 0x150 resume mends it</source>
        <translation>全部电机使能 10 s 后，3 号关节以 2°/s 继续转动 30° 而反馈不显示；0x150 恢复可消除</translation>
    </message>
    <message>
        <source>armui [OPTION ...] [FILE]
       armui COMMAND [OPTION ...]</source>
        <translation>armui [OPTION ...] [FILE]
      armui COMMAND [OPTION ...]</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>文件已存在</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>文件名太长</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>读写错误</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>设备不存在</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>文件或文件夹不存在</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>不是文件夹</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>不允许此操作</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>磁盘是只读的</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>符号链接层数过多</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>等待超时</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>数据库已损坏</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>文件不是数据库</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>无法打开数据库文件</translation>
    </message>
    <message>
        <source>say what the local interface offers to programs</source>
        <translation>说明本地接口为程序提供什么</translation>
    </message>
    <message>
        <source>serve the local interface to a language model</source>
        <translation>把本地接口提供给语言模型</translation>
    </message>
    <message>
        <source>usage: </source>
        <translation>用法：</translation>
    </message>
    <message>
        <source>Host program for the AgileX PiPER arm on a CAN bus. Without a command it opens its window.</source>
        <translation>松灵 PiPER 机械臂的上位机，通过 CAN 总线连接。不带命令时打开窗口。</translation>
    </message>
    <message>
        <source>the arm to connect to</source>
        <translation>要连接的机械臂</translation>
    </message>
    <message>
        <source>the simulated arm</source>
        <translation>仿真机械臂</translation>
    </message>
    <message>
        <source>a trajectory to open in the editor; nothing moves</source>
        <translation>要在编辑器中打开的轨迹；不会运动</translation>
    </message>
    <message>
        <source>show program&apos;s version number and exit</source>
        <translation>显示程序版本并退出</translation>
    </message>
    <message>
        <source>language of the windows</source>
        <translation>窗口的语言</translation>
    </message>
    <message>
        <source>serve the local interface for your scripts in this run; you grant what moves the arm</source>
        <translation>本次运行开启本地接口，供您的脚本使用；由您授予机械臂的操作</translation>
    </message>
    <message>
        <source>serve the live stream for Foxglove in this run; nobody can send anything by it</source>
        <translation>本次运行提供 Foxglove 实时数据流；别人不能通过它发送任何内容</translation>
    </message>
    <message>
        <source>python-can&apos;s name of the adapter, e.g. socketcan</source>
        <translation>python-can 中适配器的名称，如 socketcan</translation>
    </message>
    <message>
        <source>the adapter&apos;s channel, e.g. can0</source>
        <translation>适配器的通道，如 can0</translation>
    </message>
    <message>
        <source>bit/s, where the program sets it (1000000)</source>
        <translation>比特率 bit/s，由程序设置时有效（1000000）</translation>
    </message>
    <message>
        <source>which arm it is (the one chosen for it the last time)</source>
        <translation>机械臂型号（上次为它选择的型号）</translation>
    </message>
    <message>
        <source>connect to it</source>
        <translation>连接仿真机械臂</translation>
    </message>
    <message>
        <source>the protocol it speaks (2)</source>
        <translation>所用协议代次（2）</translation>
    </message>
    <message>
        <source>its firmware version, as S-V1.7-3 (S-V1.8-9)</source>
        <translation>其固件版本，如 S-V1.7-3（S-V1.8-9）</translation>
    </message>
    <message>
        <source>the angles in degrees at which it lies when it is switched on (as a real arm lies: 0 -1.999 1.971 -1.412 22.11 -2.608)</source>
        <translation>上电时所处的角度，单位为度（与真实机械臂一样：0 -1.999 1.971 -1.412 22.11 -2.608）</translation>
    </message>
    <message>
        <source>Show a recorded CAN log, of this program or of another one, as if it were live: a window with 3D view, joints, curves and a time line. Nothing is sent.</source>
        <translation>像实时一样回放本程序或其他程序录制的 CAN 日志：窗口中有 3D 画面、关节、曲线和时间轴。不发送任何内容。</translation>
    </message>
    <message>
        <source>the log: .blf, .asc, .log, .trc, .csv, ...</source>
        <translation>日志文件：.blf、.asc、.log、.trc、.csv 等</translation>
    </message>
    <message>
        <source>print the methods with their arguments, units and ranges as an OpenRPC document</source>
        <translation>以 OpenRPC 文档打印所有方法及其参数、单位和范围</translation>
    </message>
    <message>
        <source>Print a recorded CAN log, one line a frame, with signals and units.</source>
        <translation>显示录制的 CAN 日志，每帧一行，带信号和单位。</translation>
    </message>
    <message>
        <source>Exit code: 0 all read, 1 some lines could not be read (numbered on the error output), 2 the file is no log.</source>
        <translation>退出码：0 全部读取；1 有些行无法读取（行号在错误输出中）；2 文件不是日志。</translation>
    </message>
    <message>
        <source>log: .log (candump), .csv (python-can, SavvyCAN, ZLG) and whatever else python-can reads (.log, .asc, .blf, .trc, .csv, .db, .txt), also with .gz; - is the standard input</source>
        <translation>日志：.log（candump）、.csv（python-can、SavvyCAN、周立功）及 python-can 能读的其他格式（.log, .asc, .blf, .trc, .csv, .db, .txt），也可带 .gz；- 为标准输入</translation>
    </message>
    <message>
        <source>protocol of the recorded arm; auto looks for evidence in the log (default)</source>
        <translation>所录机械臂的协议；auto 根据日志判断（默认）</translation>
    </message>
    <message>
        <source>the arm&apos;s firmware, which says how its MIT frames are laid out, where the log does not tell it (default: S-V1.8-9)</source>
        <translation>机械臂固件，日志中没有时由它确定 MIT 帧的格式（默认：S-V1.8-9）</translation>
    </message>
    <message>
        <source>one JSON object a line</source>
        <translation>每行一个 JSON 对象</translation>
    </message>
    <message>
        <source>language of the messages</source>
        <translation>提示信息的语言</translation>
    </message>
    <message>
        <source>Look at this computer, its CAN devices and the bus, and say what is wrong, each with a command that mends it. Nothing is sent but with --ask.</source>
        <translation>检查本机、CAN 设备和总线，指出问题，并给出解决每个问题的命令。除非使用 --ask，不发送任何内容。</translation>
    </message>
    <message>
        <source>one JSON object instead of text</source>
        <translation>输出一个 JSON 对象，不输出文字</translation>
    </message>
    <message>
        <source>python-can&apos;s name of the adapter to listen to (default: all found)</source>
        <translation>要监听的适配器在 python-can 中的名称（默认：找到的全部）</translation>
    </message>
    <message>
        <source>send questions to the arm, too: version, limits, teaching handle. They move and change nothing, but other programs on the bus see them</source>
        <translation>同时向机械臂发送查询：版本、限位、示教手柄。不会运动，也不改变任何内容，但总线上的其他程序会看到</translation>
    </message>
    <message>
        <source>so long each device is listened to (2)</source>
        <translation>每个设备的监听时间，秒（2）</translation>
    </message>
    <message>
        <source>leave the bus alone: open no device</source>
        <translation>不碰总线：不打开任何设备</translation>
    </message>
    <message>
        <source>language of the report</source>
        <translation>报告的语言</translation>
    </message>
    <message>
        <source>Exit code: 0 all exported, 1 exported but for places of the log that cannot be read (named on the error output), 2 nothing written, 130 stopped with Ctrl-C.</source>
        <translation>退出码：0 全部导出；1 已导出，但日志中有些位置无法读取（见错误输出）；2 没有写入；130 被 Ctrl-C 停止。</translation>
    </message>
    <message>
        <source>format (default: what the target&apos;s name says, else mcap); csv-messages makes a folder with a file for each message, lerobot one with a dataset of LeRobot; parquet and lerobot need pyarrow</source>
        <translation>格式（默认：由目标名称决定，否则为 mcap）；csv-messages 生成一个文件夹，每种消息一个文件；lerobot 生成 LeRobot 数据集文件夹；parquet 和 lerobot 需要 pyarrow</translation>
    </message>
    <message>
        <source>target (default: the log&apos;s name with another ending)</source>
        <translation>目标文件（默认：日志名换扩展名）</translation>
    </message>
    <message>
        <source>from there on, in seconds from the log&apos;s first frame</source>
        <translation>从此处开始，自日志第一帧起的秒数</translation>
    </message>
    <message>
        <source>up to there, likewise</source>
        <translation>到此处为止，同上</translation>
    </message>
    <message>
        <source>the arm&apos;s firmware, which says where its joints have their zeros (default: what the log tells, else what fits the end pose in it)</source>
        <translation>机械臂固件，由它确定各关节零位（默认：按日志所示，否则按与其中末端位姿相符者）</translation>
    </message>
    <message>
        <source>the arm (default: what fits the end pose in the log, else piper)</source>
        <translation>机械臂型号（默认：与日志中末端位姿相符者，否则为 piper）</translation>
    </message>
    <message>
        <source>channel of the log (default: that on which most of an arm is heard)</source>
        <translation>日志的通道（默认：机械臂数据最多的通道）</translation>
    </message>
    <message>
        <source>of a dataset of LeRobot: frames a second, 1 to 200 (30)</source>
        <translation>LeRobot 数据集：每秒帧数，1 到 200（30）</translation>
    </message>
    <message>
        <source>of a dataset of LeRobot: what was done, where its episodes don&apos;t say it (PiPER)</source>
        <translation>LeRobot 数据集：片段自身未说明时的任务文字（PiPER）</translation>
    </message>
    <message>
        <source>replace a target that is there</source>
        <translation>覆盖已存在的目标文件</translation>
    </message>
    <message>
        <source>progress and result as JSON, one object a line</source>
        <translation>以 JSON 输出进度和结果，每行一个对象</translation>
    </message>
    <message>
        <source>Record every frame on a CAN bus until Ctrl-C. Nothing is sent. What is written can be read at any moment; a kill loses the last second at most.</source>
        <translation>录制 CAN 总线上的每一帧，直到 Ctrl-C。不发送任何内容。已写入的内容随时可读；进程被杀死时最多丢失最后一秒。</translation>
    </message>
    <message>
        <source>Exit code: 0 recorded as asked; 1 cut short: the disk or the device failed, what was written is whole; 2 it could not begin.</source>
        <translation>退出码：0 按要求录制；1 提前结束：磁盘或设备故障，已写入的内容完整；2 无法开始。</translation>
    </message>
    <message>
        <source>record a simulated arm that lives in this command</source>
        <translation>录制本命令自带的仿真机械臂</translation>
    </message>
    <message>
        <source>protocol of the simulated arm (2)</source>
        <translation>仿真机械臂的协议（2）</translation>
    </message>
    <message>
        <source>where to (the current folder)</source>
        <translation>保存到哪个文件夹（当前文件夹）</translation>
    </message>
    <message>
        <source>a file that is as large is followed by another (100)</source>
        <translation>文件达到此大小后换下一个（100）</translation>
    </message>
    <message>
        <source>end by itself after so long</source>
        <translation>达到此时长后自动结束</translation>
    </message>
    <message>
        <source>no progress line</source>
        <translation>不显示进度行</translation>
    </message>
    <message>
        <source>the supply is off; at the end the arm starts anew</source>
        <translation>供电断开；结束时机械臂重新启动</translation>
    </message>
    <message>
        <source>a joint turns stiffly: it stays behind, and needs more current (VALUE: joint)</source>
        <translation>关节卡滞：落后于设定值，所需电流增大（VALUE：关节）</translation>
    </message>
    <message>
        <source>a joint is 25 °C warmer than its work explains, which raises no alarm (VALUE: joint)</source>
        <translation>关节温度比正常工作高 25 °C，不触发报警（VALUE：关节）</translation>
    </message>
    <message>
        <source>a joint slips by 5°; its feedback shows it at the next 0x150 resume (VALUE: joint)</source>
        <translation>关节滑移 5°；下一次解除急停（0x150）时反馈才显示（VALUE：关节）</translation>
    </message>
    <message>
        <source>the host&apos;s adapter sends, but hands over nothing that it hears</source>
        <translation>主机的适配器能发送，却不交出任何收到的帧</translation>
    </message>
    <message>
        <source>the bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>the arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>the local interface, on a private bus</source>
        <translation>本地接口，在私有总线上</translation>
    </message>
    <message>
        <source>what goes wrong</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>python-can&apos;s name of the bus (udp_multicast)</source>
        <translation>python-can 中总线的名称（udp_multicast）</translation>
    </message>
    <message>
        <source>the bus&apos;s channel, e.g. vcan0</source>
        <translation>总线的通道，如 vcan0</translation>
    </message>
    <message>
        <source>of udp_multicast: another port than python-can&apos;s own, by which other programs find the arm; two arms need two ports, for two groups on one port are one bus</source>
        <translation>udp_multicast 的端口：不同于 python-can 自身的端口（其他程序按它找到机械臂）；两台机械臂需要两个端口，因为同一端口上的两个组是同一条总线</translation>
    </message>
    <message>
        <source>bit/s, where the program sets it</source>
        <translation>比特率 bit/s，由程序设置时有效</translation>
    </message>
    <message>
        <source>move its feedback and motion commands by 0x10 or 0x20, for another arm on one bus</source>
        <translation>将其反馈和运动指令偏移 0x10 或 0x20，以便同一总线上有另一台机械臂</translation>
    </message>
    <message>
        <source>what it answers when asked for its version, and what it does as this version does: MIT, CPV, frames, signs, scales; generation 2 only (S-V1.8-9)</source>
        <translation>查询版本时的应答，并按该版本工作：MIT、CPV、帧、符号、比例；仅第 2 代（S-V1.8-9）</translation>
    </message>
    <message>
        <source>which arm of the family it is: piper, piper_h, piper_l, piper_x (piper)</source>
        <translation>系列中的型号：piper, piper_h, piper_l, piper_x（piper）</translation>
    </message>
    <message>
        <source>the angles in degrees at which it lies when it is switched on; a real arm lies at 0 -1.999 1.971 -1.412 22.11 -2.608 (0 0 0 0 0 0)</source>
        <translation>上电时所处的角度，单位为度；真实机械臂处于 0 -1.999 1.971 -1.412 22.11 -2.608（0 0 0 0 0 0）</translation>
    </message>
    <message>
        <source>keep its settings in this file; without it they end with the command</source>
        <translation>将其设置保存在此文件中；否则随命令结束而丢失</translation>
    </message>
    <message>
        <source>serve the local interface, with the program&apos;s checks and no window: for the tests and scripts of clients</source>
        <translation>提供本地接口，带程序的全部检查而无窗口：供客户端的测试和脚本使用</translation>
    </message>
    <message>
        <source>grant the lease to whoever asks: nobody else is here</source>
        <translation>向任何申请者授予租约：此处没有其他人</translation>
    </message>
    <message>
        <source>where it is served (the user&apos;s own place)</source>
        <translation>提供接口的位置（默认在用户自己的文件夹）</translation>
    </message>
    <message>
        <source>the library that clients see (the user&apos;s own)</source>
        <translation>客户端可见的轨迹库（默认为用户自己的）</translation>
    </message>
    <message>
        <source>break something, in seconds from the start; may be given often</source>
        <translation>制造故障，时间为启动后的秒数；可多次给出</translation>
    </message>
    <message>
        <source>have known bugs of firmware versions, to try a host&apos;s answers to them: without names those reported of its version, or all, or some of them</source>
        <translation>带有固件版本的已知缺陷，用于试验上位机的应对：不写名称为该版本已报告的缺陷，或 all，或其中几个</translation>
    </message>
    <message>
        <source>of all that is left to chance: noise, lost frames (0)</source>
        <translation>随机种子，用于噪声、丢帧等（0）</translation>
    </message>
    <message>
        <source>--interface and --channel go together</source>
        <translation>--interface 与 --channel 必须同时给出</translation>
    </message>
    <message>
        <source>--sim is a device of its own: leave out --interface</source>
        <translation>--sim 本身就是设备：请去掉 --interface</translation>
    </message>
    <message>
        <source>--generation belongs to --sim: a real arm says for itself which it is</source>
        <translation>--generation 只用于 --sim：真实机械臂会自行说明</translation>
    </message>
    <message>
        <source>--firmware belongs to --sim in generation 2: a real arm tells its own</source>
        <translation>--firmware 只用于第 2 代的 --sim：真实机械臂会自行说明</translation>
    </message>
    <message>
        <source>--joints belongs to --sim: a real arm says for itself how it lies</source>
        <translation>--joints 只用于 --sim：真实机械臂会自行说明</translation>
    </message>
    <message>
        <source>{file!r} is neither a file nor a command: see armui --help</source>
        <translation>{file!r} 既不是文件也不是命令，见 armui --help</translation>
    </message>
    <message>
        <source>no display found. Start it in a desktop session, or set DISPLAY or WAYLAND_DISPLAY. `armui doctor` tells more.</source>
        <translation>没有可用的显示。请在桌面会话中启动，或设置 DISPLAY 或 WAYLAND_DISPLAY。更多信息见 `armui doctor`。</translation>
    </message>
    <message>
        <source>as the log says</source>
        <translation>日志中如此说明</translation>
    </message>
    <message>
        <source>no log of this program: there is no sidecar beside it</source>
        <translation>不是本程序的日志：旁边没有附带文件</translation>
    </message>
    <message>
        <source>{text!r} is no firmware version; write it as {example}</source>
        <translation>{text!r} 不是固件版本，应写成 {example} 的形式</translation>
    </message>
    <message>
        <source>the window cannot be loaded: {error}. `armui doctor` says what is missing, and how to install it.</source>
        <translation>无法加载窗口：{error}。`armui doctor` 会指出缺少什么、如何安装。</translation>
    </message>
    <message>
        <source>of the log (session-DATE-TIME)</source>
        <translation>日志的名称（session-日期-时间）</translation>
    </message>
    <message>
        <source>read as generation {number}: {reason}</source>
        <translation>按第 {number} 代协议读取：{reason}</translation>
    </message>
    <message>
        <source>{count} further places cannot be read</source>
        <translation>还有 {count} 处无法读取</translation>
    </message>
    <message>
        <source>firmware {version}, as the log tells</source>
        <translation>固件 {version}（日志中的信息）</translation>
    </message>
    <message>
        <source>firmware {version} on {channel}; all MIT frames are read as those of {first}</source>
        <translation>{channel} 上的固件为 {version}；所有 MIT 帧均按 {first} 读取</translation>
    </message>
    <message>
        <source>firmware {version}, as --firmware says, unless the log tells another</source>
        <translation>固件 {version}（--firmware 指定），日志中另有说明时除外</translation>
    </message>
    <message>
        <source>the log names no firmware: MIT frames are read as those of S-V1.8-8 and later; say --firmware if the arm is older</source>
        <translation>日志中没有固件版本：MIT 帧按 S-V1.8-8 及更新的固件读取；机械臂固件更旧时，请用 --firmware 指定</translation>
    </message>
    <message>
        <source>from here on read as generation {number}: {reason}</source>
        <translation>此后按第 {number} 代协议读取：{reason}</translation>
    </message>
    <message>
        <source>{text!r} is not within 0.1 to {most:g} seconds</source>
        <translation>{text!r} 不在 0.1 至 {most:g} 秒之间</translation>
    </message>
    <message>
        <source>no frame of the channel {channel!r} near its beginning; there are: {detail}</source>
        <translation>开头附近没有通道 {channel!r} 的帧；现有通道：{detail}</translation>
    </message>
    <message>
        <source>nothing to export: it has no frames; no file was written</source>
        <translation>没有可导出的内容：文件中没有帧；未写入任何文件</translation>
    </message>
    <message>
        <source>nothing to export: no frame in it is an arm&apos;s; no file was written (armui decode shows what is in it)</source>
        <translation>没有可导出的内容：其中没有机械臂的帧；未写入任何文件（用 armui decode 可查看其内容）</translation>
    </message>
    <message>
        <source>nothing to export: a table has a row for each set of joint angles (0x2A5-0x2A7), and none was heard; no file was written (--to mcap wants none)</source>
        <translation>没有可导出的内容：表格的每一行对应一组关节角（0x2A5-0x2A7），而日志中没有；未写入任何文件（--to mcap 不需要关节角）</translation>
    </message>
    <message>
        <source>nothing to export: nothing was heard between --from and --to-time; no file was written</source>
        <translation>没有可导出的内容：--from 与 --to-time 之间没有数据；未写入任何文件</translation>
    </message>
    <message>
        <source>{target} is there already; give another name with -o, or --force to replace it</source>
        <translation>{target} 已存在；请用 -o 指定其他名称，或用 --force 替换</translation>
    </message>
    <message>
        <source>the target is the log itself; give another name with -o</source>
        <translation>目标就是日志本身；请用 -o 指定其他名称</translation>
    </message>
    <message>
        <source>cannot write {target}: {detail}</source>
        <translation>无法写入 {target}：{detail}</translation>
    </message>
    <message>
        <source>Parquet needs the package pyarrow: pip install &apos;armui[parquet]&apos; (CSV has the same table without it)</source>
        <translation>Parquet 需要 pyarrow 包：pip install &apos;armui[parquet]&apos;（CSV 不需要它，表格内容相同）</translation>
    </message>
    <message>
        <source>nothing to export: no stretch of a second in which the angles were heard and the arm told no fault; no dataset was written</source>
        <translation>没有可导出的内容：没有任何一秒既收到关节角度、机械臂又无故障；未写入数据集</translation>
    </message>
    <message>
        <source>{target} is there already, and a dataset is never replaced; give another name with -o</source>
        <translation>{target} 已存在，数据集从不被替换；请用 -o 指定其他名称</translation>
    </message>
    <message>
        <source>taken for a {model}: {reason}</source>
        <translation>视为 {model}：{reason}</translation>
    </message>
    <message>
        <source>{target}: {count:,} rows</source>
        <translation>{target}：{count:,} 行</translation>
    </message>
    <message>
        <source>the arm&apos;s feedback has the identifier offset 0x{offset:02X} (0x470)</source>
        <translation>机械臂的反馈带有标识符偏移 0x{offset:02X}（0x470）</translation>
    </message>
    <message>
        <source>only the channel {channel} was exported; {count:,} frames of {others} were left out (--channel chooses)</source>
        <translation>只导出了通道 {channel}；略去了 {others} 的 {count:,} 帧（可用 --channel 选择）</translation>
    </message>
    <message>
        <source>{count:,} frames are none of the arm&apos;s and were left out (armui decode shows them)</source>
        <translation>略去了 {count:,} 个不属于机械臂的帧（用 armui decode 可查看）</translation>
    </message>
    <message>
        <source>{count:,} frames ask for the firmware version, as armui does when it connects; generation 1 does not answer them</source>
        <translation>有 {count:,} 帧在查询固件版本（armui 连接时即如此）；第 1 代不回答</translation>
    </message>
    <message>
        <source>{count:,} frames have a time that no ROS time stamp can tell and were left out</source>
        <translation>略去了 {count:,} 个时间无法用 ROS 时间戳表示的帧</translation>
    </message>
    <message>
        <source>{count:,} frames</source>
        <translation>{count:,} 帧</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>已停止；未写入任何内容</translation>
    </message>
    <message>
        <source>{target}: {count:,} messages</source>
        <translation>{target}：{count:,} 条消息</translation>
    </message>
    <message>
        <source>{text!r} is no number of seconds, 0 or more</source>
        <translation>{text!r} 不是秒数（应为不小于 0 的数）</translation>
    </message>
    <message>
        <source>{text!r} is no rate of 1 to 200 frames a second</source>
        <translation>{text!r} 不是每秒 1 到 200 帧的速率</translation>
    </message>
    <message>
        <source>{target}: {count:,} frames</source>
        <translation>{target}：{count:,} 帧</translation>
    </message>
    <message>
        <source>{seconds:.0f} s left</source>
        <translation>剩余 {seconds:.0f} 秒</translation>
    </message>
    <message>
        <source>armui mcp: {error}. In a copy of armui&apos;s repository: pip install ./resources/clients/armui_client ./resources/clients/armui_mcp</source>
        <translation>armui mcp：{error}。请在 armui 仓库中运行：pip install ./resources/clients/armui_client ./resources/clients/armui_mcp</translation>
    </message>
    <message>
        <source>nothing tells, and arms in use today speak it</source>
        <translation>日志中没有依据，而目前使用的机械臂均为这一代</translation>
    </message>
    <message>
        <source>the arm named its firmware {version}</source>
        <translation>机械臂报告了固件 {version}</translation>
    </message>
    <message>
        <source>the feedback comes every {period:.1f} ms</source>
        <translation>反馈周期为 {period:.1f} ms</translation>
    </message>
    <message>
        <source>frames that fit only this generation: {this}, only the other: {other}</source>
        <translation>只符合这一代的帧：{this}，只符合另一代的帧：{other}</translation>
    </message>
    <message>
        <source>{count} frames, {size}</source>
        <translation>{count} 帧，{size}</translation>
    </message>
    <message>
        <source>{count} frames were lost: the disk was too slow</source>
        <translation>丢失了 {count} 帧：磁盘太慢</translation>
    </message>
    <message>
        <source>{name!r} is no name for a file; leave out / \ : * ? &quot; &lt; &gt; |</source>
        <translation>{name!r} 不能用作文件名；请去掉 / \ : * ? &quot; &lt; &gt; |</translation>
    </message>
    <message>
        <source>its faults were not counted: {text}</source>
        <translation>未能统计其中的故障：{text}</translation>
    </message>
    <message>
        <source>the disk does not answer; its last frames may be missing</source>
        <translation>磁盘没有响应；最后的帧可能缺失</translation>
    </message>
    <message>
        <source>not one frame was heard; `armui doctor` tells more</source>
        <translation>一帧也没有收到；更多信息见 `armui doctor`</translation>
    </message>
    <message>
        <source>{count} lost</source>
        <translation>丢失 {count} 帧</translation>
    </message>
    <message>
        <source>name the bus: --interface and --channel, or --sim</source>
        <translation>请指定总线：--interface 与 --channel，或 --sim</translation>
    </message>
    <message>
        <source>{text!r} is not within 1 to {most} MB</source>
        <translation>{text!r} 不在 1 至 {most} MB 之间</translation>
    </message>
    <message>
        <source>{text!r} is no number of seconds</source>
        <translation>{text!r} 不是秒数</translation>
    </message>
    <message>
        <source>{device} is gone: {text}</source>
        <translation>{device} 已断开：{text}</translation>
    </message>
    <message>
        <source>`armui doctor` tells more.</source>
        <translation>更多信息见 `armui doctor`。</translation>
    </message>
    <message>
        <source>0x{can_id:03X} with {count} bytes of data, but another length</source>
        <translation>0x{can_id:03X} 带有 {count} 字节数据，与所写长度不符</translation>
    </message>
    <message>
        <source>identifier 0x{can_id:X} in a frame whose identifiers have {bits} bits</source>
        <translation>标识符 0x{can_id:X} 超出该帧的 {bits} 位标识符</translation>
    </message>
    <message>
        <source>its time is no number</source>
        <translation>时间不是数</translation>
    </message>
    <message>
        <source>frame {frame}</source>
        <translation>第 {frame} 帧</translation>
    </message>
    <message>
        <source>its time is none that a log can have</source>
        <translation>时间超出日志可能的范围</translation>
    </message>
    <message>
        <source>more than {most} channels; the others are read as one</source>
        <translation>通道超过 {most} 个；其余的合为一个读取</translation>
    </message>
    <message>
        <source>its parts are no numbers</source>
        <translation>内容不是数</translation>
    </message>
    <message>
        <source>channel {channel}</source>
        <translation>通道 {channel}</translation>
    </message>
    <message>
        <source>byte {byte}</source>
        <translation>第 {byte} 字节</translation>
    </message>
    <message>
        <source>{reason}, after {count} frames</source>
        <translation>{reason}，在第 {count} 帧之后</translation>
    </message>
    <message>
        <source>damaged here; the next object begins at byte {byte}</source>
        <translation>此处损坏；下一个对象从第 {byte} 字节开始</translation>
    </message>
    <message>
        <source>an object in this part of the file has {size} bytes, not {least}</source>
        <translation>文件这一部分中有一个对象只有 {size} 字节，应有 {least} 字节</translation>
    </message>
    <message>
        <source>no CAN log: it does not begin as a BLF file</source>
        <translation>不是 CAN 日志：文件开头不是 BLF 格式</translation>
    </message>
    <message>
        <source>packed by the unknown method {method}</source>
        <translation>压缩方法 {method} 未知</translation>
    </message>
    <message>
        <source>an object in this part of the file claims {size} bytes</source>
        <translation>文件这一部分中有一个对象声称有 {size} 字节</translation>
    </message>
    <message>
        <source>the file breaks off here</source>
        <translation>文件在此处中断</translation>
    </message>
    <message>
        <source>no object begins here, and none follows</source>
        <translation>此处没有对象，之后也没有</translation>
    </message>
    <message>
        <source>damaged here ({error})</source>
        <translation>此处损坏（{error}）</translation>
    </message>
    <message>
        <source>what this part of the file holds is damaged</source>
        <translation>文件这一部分的内容已损坏</translation>
    </message>
    <message>
        <source>row {row}</source>
        <translation>第 {row} 行</translation>
    </message>
    <message>
        <source>no CAN log: {error}</source>
        <translation>不是 CAN 日志：{error}</translation>
    </message>
    <message>
        <source>no CAN log: the database has no table «messages»</source>
        <translation>不是 CAN 日志：数据库中没有 messages 表</translation>
    </message>
    <message>
        <source>the file is damaged from here on ({error})</source>
        <translation>文件从此处起已损坏（{error}）</translation>
    </message>
    <message>
        <source>as asked for</source>
        <translation>按要求</translation>
    </message>
    <message>
        <source>{why}; but its end pose fits a {fits}</source>
        <translation>{why}；但末端位姿更符合 {fits}</translation>
    </message>
    <message>
        <source>its end pose fits</source>
        <translation>与末端位姿相符</translation>
    </message>
    <message>
        <source>nothing in the log tells</source>
        <translation>日志中没有依据</translation>
    </message>
    <message>
        <source>{place} cannot be read: {reason}</source>
        <translation>{place}无法读取：{reason}</translation>
    </message>
    <message>
        <source>{place} contradicts itself: {reason}</source>
        <translation>{place}自相矛盾：{reason}</translation>
    </message>
    <message>
        <source>of BUSMASTER: convert it there to .asc</source>
        <translation>BUSMASTER 的文件：请在其中转换为 .asc</translation>
    </message>
    <message>
        <source>of Kvaser CanKing: save it there as Vector&apos;s .asc</source>
        <translation>Kvaser CanKing 的文件：请在其中另存为 Vector 的 .asc</translation>
    </message>
    <message>
        <source>of Wireshark: record with candump -l or armui record instead</source>
        <translation>Wireshark 的文件：请改用 candump -l 或 armui record 记录</translation>
    </message>
    <message>
        <source>of ZLG or the like with other titles than CANTest&apos;s: save it there as .asc</source>
        <translation>致远等软件的文件，但表头与 CANTest 不同：请在其中另存为 .asc</translation>
    </message>
    <message>
        <source>with titles that are not known (SavvyCAN&apos;s, ZLG&apos;s and python-can&apos;s are): save it as .asc, .blf or .trc where it was recorded</source>
        <translation>表头未知的表格（已知 SavvyCAN、致远和 python-can 的表头）：请在记录软件中另存为 .asc、.blf 或 .trc</translation>
    </message>
    <message>
        <source>no CAN log: nothing in it reads as a frame of a {kind} file</source>
        <translation>不是 CAN 日志：其中没有能按 {kind} 格式读取的帧</translation>
    </message>
    <message>
        <source>{reason} ({error})</source>
        <translation>{reason}（{error}）</translation>
    </message>
    <message>
        <source>it is packed: unpack it before, as with zcat run.log.gz | ...</source>
        <translation>内容是压缩的：请先解压，例如 zcat run.log.gz | ...</translation>
    </message>
    <message>
        <source>a database is read from its file only</source>
        <translation>数据库只能从文件读取</translation>
    </message>
    <message>
        <source>MF4 is not read: convert it to .asc or .blf with other software, for example asammdf</source>
        <translation>不读取 MF4：请用其他软件（例如 asammdf）转换为 .asc 或 .blf</translation>
    </message>
    <message>
        <source>unknown kind of log {kind!r}; known are {known}, and these but {plain} with .gz</source>
        <translation>未知的日志类型 {kind!r}；支持 {known}，以及除 {plain} 外带 .gz 的这些类型</translation>
    </message>
    <message>
        <source>{reason}; it looks like a {kind} file: give it that suffix</source>
        <translation>{reason}；它像是 {kind} 文件：请改用该后缀</translation>
    </message>
    <message>
        <source>{reason}; it looks like a file {way}</source>
        <translation>{reason}；看起来是{way}</translation>
    </message>
    <message>
        <source>byte {byte} of a block</source>
        <translation>某一块的第 {byte} 字节</translation>
    </message>
    <message>
        <source>the file breaks off in a line</source>
        <translation>文件在一行中间中断</translation>
    </message>
    <message>
        <source>the file breaks off before it</source>
        <translation>文件在此之前中断</translation>
    </message>
    <message>
        <source>the index beside it does not belong to it</source>
        <translation>旁边的索引不属于它</translation>
    </message>
    <message>
        <source>what is packed in it is damaged</source>
        <translation>其中压缩的内容已损坏</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>第 {line} 行</translation>
    </message>
    <message>
        <source>after line {line}</source>
        <translation>第 {line} 行之后</translation>
    </message>
    <message>
        <source>nothing in so many bytes is a frame; the rest is not read</source>
        <translation>连续很多字节中没有一帧；其余部分未读取</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>the standard output cannot be written: {reason}</source>
        <translation>无法写入标准输出：{reason}</translation>
    </message>
    <message>
        <source>{text!r} is no angle; give degrees from -{most:g} to {most:g}</source>
        <translation>{text!r} 不是角度；请给出 -{most:g} 至 {most:g} 之间的度数</translation>
    </message>
    <message>
        <source>a file is needed here, not the standard input: keep what comes first, for example with candump -L can0 &gt; run.log</source>
        <translation>此处需要文件，不能用标准输入：请先保存，例如 candump -L can0 &gt; run.log</translation>
    </message>
    <message>
        <source>it is a folder, not a file</source>
        <translation>是文件夹，不是文件</translation>
    </message>
    <message>
        <source>it is a pipe, not a file</source>
        <translation>是管道，不是文件</translation>
    </message>
    <message>
        <source>it is a socket, not a file</source>
        <translation>是套接字，不是文件</translation>
    </message>
    <message>
        <source>it is a device, not a file</source>
        <translation>是设备，不是文件</translation>
    </message>
    <message>
        <source>it is something else, not a file</source>
        <translation>不是文件</translation>
    </message>
    <message>
        <source>a joint reports an excursion of 60° and its return, and stands as far off from then on; 0x150 resume mends it (VALUE: joint)</source>
        <translation>一个关节上报 60° 的偏移后又返回，此后实际位置便相差这么多；用 0x150 恢复可修复 (VALUE: 关节)</translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>It moves the arm: choose it by the arrow keys, or type its name.</source>
        <translation>会使机械臂运动：请用方向键选择，或输入完整名称。</translation>
    </message>
    <message>
        <source>No command has that name. Search in Chinese, English, pinyin or initials.</source>
        <translation>没有这样的名称。可按中文、英文、拼音或拼音首字母查找。</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Name, pinyin or initials, in Chinese or English</source>
        <translation>名称、拼音或首字母，中英文均可</translation>
    </message>
    <message>
        <source>Search for a command</source>
        <translation>查找命令</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>找到的命令</translation>
    </message>
</context>
<context>
    <name>CommandsButton</name>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Find every function by its name</source>
        <translation>按名称查找任意功能</translation>
    </message>
</context>
<context>
    <name>CommunicationButton</name>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>连接中…</translation>
    </message>
    <message>
        <source>Offline</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>Online</source>
        <translation>在线</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>连接断开</translation>
    </message>
    <message>
        <source>No CAN device is connected. Press to choose one.</source>
        <translation>没有连接 CAN 设备。点击选择设备。</translation>
    </message>
    <message>
        <source>The CAN device is being opened.</source>
        <translation>正在打开 CAN 设备。</translation>
    </message>
    <message>
        <source>The CAN device is open, but no arm is heard on it. Check the arm&apos;s power, the cable and the bit rate.</source>
        <translation>CAN 设备已打开，但没有收到机械臂的反馈。请检查机械臂电源、线缆和波特率。</translation>
    </message>
    <message>
        <source>The arm is heard. Press to disconnect or choose another.</source>
        <translation>正在接收机械臂的反馈。点击可断开或选择其他设备。</translation>
    </message>
    <message>
        <source>The CAN device is gone. Plug it in again: it is reconnected by itself.</source>
        <translation>CAN 设备已断开。重新插好后会自动连接。</translation>
    </message>
    <message>
        <source>Its feedback comes from {feedback} on; see Linkage control.</source>
        <translation>其反馈 ID 从 {feedback} 起，详见“联动控制”。</translation>
    </message>
    <message>
        <source>May be moving</source>
        <translation>可能仍在运动</translation>
    </message>
    <message>
        <source>Choose a device</source>
        <translation>选择设备</translation>
    </message>
</context>
<context>
    <name>ConfirmDialog</name>
    <message>
        <source>The work area does not hold it then: below the arm is {names}.</source>
        <translation>此时工作区拦不住它：机械臂下方是 {names}。</translation>
    </message>
    <message>
        <source>Below the floor</source>
        <translation>低于地面</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>前往</translation>
    </message>
    <message>
        <source>Hold the button, or the space bar on it, for one second.</source>
        <translation>请按住按钮（或在按钮上按住空格键）1 秒。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>ConnectDialog</name>
    <message>
        <source>Connect arm</source>
        <translation>连接机械臂</translation>
    </message>
    <message>
        <source>CAN devices</source>
        <translation>CAN 设备</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>刷新</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Diagnosis…</source>
        <translation>诊断…</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Listen only</source>
        <translation>只听</translation>
    </message>
    <message>
        <source>For use beside another program: nothing but the emergency stop is sent.</source>
        <translation>与其他程序同时使用：除急停外不发送任何帧。</translation>
    </message>
    <message>
        <source>{bitrate} (generation 1)</source>
        <translation>{bitrate}（第 1 代）</translation>
    </message>
    <message>
        <source>The device is not in the list? Enter it:</source>
        <translation>列表中没有设备？请手动输入：</translation>
    </message>
    <message>
        <source>The arm is moving</source>
        <translation>机械臂正在运动</translation>
    </message>
    <message>
        <source>Without the connection the arm goes on to its target, and the emergency stop of this program cannot reach it.</source>
        <translation>断开后机械臂会继续运动到目标点，本程序的急停也无法再使其停止。</translation>
    </message>
    <message>
        <source>Choose a device in the list first.</source>
        <translation>请先在列表中选择设备。</translation>
    </message>
    <message>
        <source>This device is connected.</source>
        <translation>该设备已连接。</translation>
    </message>
    <message>
        <source>No device is connected.</source>
        <translation>没有已连接的设备。</translation>
    </message>
    <message>
        <source>The search is under way.</source>
        <translation>正在搜索。</translation>
    </message>
    <message>
        <source>Connecting to {device}…</source>
        <translation>正在连接 {device}…</translation>
    </message>
    <message>
        <source>Online: {device}</source>
        <translation>在线：{device}</translation>
    </message>
    <message>
        <source>Searching for devices…</source>
        <translation>正在搜索设备…</translation>
    </message>
    <message>
        <source>Choose a device and press Connect.</source>
        <translation>请选择设备，然后按“连接”。</translation>
    </message>
    <message>
        <source>The simulated arm has no bit rate.</source>
        <translation>仿真机械臂没有波特率。</translation>
    </message>
    <message>
        <source>Set by the operating system, not by this program.</source>
        <translation>由操作系统设置，本程序不能更改。</translation>
    </message>
    <message>
        <source>Disconnect to change it.</source>
        <translation>断开后可更改。</translation>
    </message>
</context>
<context>
    <name>ConsentDialog</name>
    <message>
        <source>“{client}” wants: {operation}</source>
        <translation>“{client}”请求：{operation}</translation>
    </message>
    <message>
        <source>Allow once</source>
        <translation>允许一次</translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation>还有 {count} 条</translation>
    </message>
</context>
<context>
    <name>ControlMode</name>
    <message>
        <source>Standby mode</source>
        <translation>待机模式</translation>
    </message>
    <message>
        <source>CAN command control mode</source>
        <translation>CAN 指令控制模式</translation>
    </message>
    <message>
        <source>Teaching mode</source>
        <translation>示教模式</translation>
    </message>
    <message>
        <source>Ethernet control mode</source>
        <translation>以太网控制模式</translation>
    </message>
    <message>
        <source>Wi-Fi control mode</source>
        <translation>wifi 控制模式</translation>
    </message>
    <message>
        <source>Remote controller mode</source>
        <translation>遥控器控制模式</translation>
    </message>
    <message>
        <source>Linked teaching input mode</source>
        <translation>联动示教输入模式</translation>
    </message>
    <message>
        <source>Offline trajectory mode</source>
        <translation>离线轨迹模式</translation>
    </message>
</context>
<context>
    <name>ControlModeShort</name>
    <message>
        <source>Standby</source>
        <translation>待机</translation>
    </message>
    <message>
        <source>CAN commands</source>
        <translation>CAN 指令</translation>
    </message>
    <message>
        <source>Teaching</source>
        <translation>示教</translation>
    </message>
    <message>
        <source>Ethernet</source>
        <translation>以太网</translation>
    </message>
    <message>
        <source>Wi-Fi</source>
        <translation>wifi</translation>
    </message>
    <message>
        <source>Remote controller</source>
        <translation>遥控器</translation>
    </message>
    <message>
        <source>Linked teaching input</source>
        <translation>联动示教输入</translation>
    </message>
    <message>
        <source>Offline trajectory</source>
        <translation>离线轨迹</translation>
    </message>
</context>
<context>
    <name>CursorTable</name>
    <message>
        <source>Quantity</source>
        <translation>物理量</translation>
    </message>
</context>
<context>
    <name>CurveMenu</name>
    <message>
        <source>Show as curve</source>
        <translation>显示为曲线</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>Simulated arm, gen. {generation}</source>
        <translation>仿真机械臂（第 {generation} 代）</translation>
    </message>
</context>
<context>
    <name>DeviceModel</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>连接中…</translation>
    </message>
    <message>
        <source>Offline</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>Online</source>
        <translation>在线</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>连接断开</translation>
    </message>
</context>
<context>
    <name>Diagnosis</name>
    <message>
        <source>armui {armui}, Python {version}, {system}.</source>
        <translation>armui {armui}，运行于 Python {version}，{system}。</translation>
    </message>
    <message>
        <source>armui {armui} needs Python 3.11 or newer; this is {version} on {system}. Install a newer Python.</source>
        <translation>armui {armui} 需要 Python 3.11 或更高版本，当前为 {version}（{system}）。请安装新版 Python。</translation>
    </message>
    <message>
        <source>All {count} packages are installed in a suitable version.</source>
        <translation>所需的 {count} 个软件包均已安装，版本合适。</translation>
    </message>
    <message>
        <source>On a busy computer, window, bus and stop may go before other programs.</source>
        <translation>电脑繁忙时，本程序的窗口、总线和急停可优先运行。</translation>
    </message>
    <message>
        <source>On a busy computer, window, bus and stop wait their turn behind other programs: {text}. A stop may then leave some tenths of a second later. Install rtkit, or close what keeps the computer busy.</source>
        <translation>电脑繁忙时，本程序的窗口、总线和急停须与其他程序轮流运行（{text}），急停可能晚零点几秒发出。请安装 rtkit，或关闭占用电脑的程序。</translation>
    </message>
    <message>
        <source>The package {package} is missing. Install it.</source>
        <translation>缺少软件包 {package}，请安装。</translation>
    </message>
    <message>
        <source>The package {package} is installed as {installed}; {wanted} is needed.</source>
        <translation>软件包 {package} 的版本为 {installed}，需要 {wanted}。</translation>
    </message>
    <message>
        <source>Nothing is kept in these folders, neither settings nor trajectories, recordings or events that belong there: {folders}. Let this user write there.</source>
        <translation>以下文件夹中什么都无法保存，无论是其中的设置、轨迹、录制还是事件：{folders}。请允许当前用户写入。</translation>
    </message>
    <message>
        <source>Qt {qt} draws through {platform}.</source>
        <translation>Qt {qt} 通过 {platform} 显示。</translation>
    </message>
    <message>
        <source>Qt cannot be loaded: {text}</source>
        <translation>无法加载 Qt：{text}</translation>
    </message>
    <message>
        <source>System libraries that Qt needs are missing: {libraries}.</source>
        <translation>缺少 Qt 需要的系统库：{libraries}。</translation>
    </message>
    <message>
        <source>Qt {qt} is installed, but there is no desktop session: start the program in one, or name its display.</source>
        <translation>Qt {qt} 可用，但没有桌面会话：请在桌面会话中启动程序，或指定显示器。</translation>
    </message>
    <message>
        <source>Qt {qt} cannot open a display: {text}</source>
        <translation>Qt {qt} 无法打开显示：{text}</translation>
    </message>
    <message>
        <source>OpenGL for the 3D picture: {renderer}.</source>
        <translation>3D 画面使用的 OpenGL：{renderer}。</translation>
    </message>
    <message>
        <source>OpenGL for the 3D picture is drawn by the processor ({renderer}): slower, but it works. A graphics driver makes it faster.</source>
        <translation>3D 画面的 OpenGL 由处理器绘制（{renderer}）：较慢但可用。安装显卡驱动可以加快。</translation>
    </message>
    <message>
        <source>The 3D picture cannot be drawn, the rest of the program works: {text}</source>
        <translation>无法绘制 3D 画面，程序其余部分可用：{text}</translation>
    </message>
    <message>
        <source>CAN devices cannot be searched for: {text}</source>
        <translation>无法搜索 CAN 设备：{text}</translation>
    </message>
    <message>
        <source>No CAN device is found. Plug in the adapter; try another cable and another USB port.</source>
        <translation>没有找到 CAN 设备。请插入适配器，或更换数据线和 USB 接口。</translation>
    </message>
    <message>
        <source>{device}, serial number {serial}.</source>
        <translation>{device}，序列号 {serial}。</translation>
    </message>
    <message>
        <source>{adapter} ({usb}, serial number {serial}) is plugged in, but has no CAN interface: its driver is not loaded. In a virtual machine, hand the USB device over to it; WSL has no CAN in its usual kernel.</source>
        <translation>{adapter}（{usb}，序列号 {serial}）已插入，但没有生成 CAN 接口：驱动未加载。虚拟机中请先把 USB 设备交给虚拟机；WSL 的默认内核不含 CAN。</translation>
    </message>
    <message>
        <source>{path} may not be opened by this user; it belongs to the group {group}. Join it, then log out and in again.</source>
        <translation>当前用户无权打开 {path}，它属于用户组 {group}。请加入该组，然后注销并重新登录。</translation>
    </message>
    <message>
        <source>{channel} ({kind}) is up, {bitrate} bit/s, {state}, error counters {tx}/{rx}, serial number {serial}.</source>
        <translation>{channel}（{kind}）已启用，{bitrate} bit/s，{state}，错误计数 {tx}/{rx}，序列号 {serial}。</translation>
    </message>
    <message>
        <source>{channel} is switched off. Switch it on with the arm&apos;s bit rate.</source>
        <translation>{channel} 未启用。请按机械臂的波特率启用。</translation>
    </message>
    <message>
        <source>{channel} is off the bus (bus-off): too many errors. Check the cable, the terminating resistors and the bit rate ({bitrate}), then bring it back.</source>
        <translation>{channel} 已离线（bus off）：错误过多。请检查电缆、终端电阻和波特率（{bitrate}），然后恢复。</translation>
    </message>
    <message>
        <source>{channel} sees many errors ({state}, counters {tx}/{rx}): nobody acknowledges, or the bit rate {bitrate} is not the arm&apos;s. Is the arm switched on? CAN_H and CAN_L swapped? 120 Ω at both ends?</source>
        <translation>{channel} 错误很多（{state}，计数 {tx}/{rx}）：没有节点应答，或波特率 {bitrate} 与机械臂不符。机械臂是否上电？CAN_H 与 CAN_L 是否接反？两端是否有 120 Ω 终端电阻？</translation>
    </message>
    <message>
        <source>{channel} counts errors ({tx}/{rx}): look at cable and terminating resistors.</source>
        <translation>{channel} 出现错误（{tx}/{rx}）：请检查电缆和终端电阻。</translation>
    </message>
    <message>
        <source>{channel} runs at {bitrate} bit/s; arms run at 1000000 (today&apos;s) or 500000 (generation 1&apos;s text).</source>
        <translation>{channel} 的波特率为 {bitrate} bit/s；机械臂为 1000000（当前）或 500000（第 1 代协议文本）。</translation>
    </message>
    <message>
        <source>{channel} runs at {bitrate} bit/s, as generation 1&apos;s text says; today&apos;s arms run at 1000000.</source>
        <translation>{channel} 的波特率为 {bitrate} bit/s，与第 1 代协议文本一致；当前机械臂为 1000000。</translation>
    </message>
    <message>
        <source>{channel} is in listen-only mode: no command and no emergency stop goes out.</source>
        <translation>{channel} 处于只听模式：任何指令和急停都发不出去。</translation>
    </message>
    <message>
        <source>{channel} is deaf: since it was switched on it has sent {sent} frames, received none, and counts no error. Unplug the adapter and plug it in again. If that does not help, check CAN_H and CAN_L, the bit rate ({bitrate}), the terminating resistors and the arm&apos;s power.</source>
        <translation>{channel} 收不到任何帧：接通以来已发送 {sent} 帧，一帧也没收到，也没有错误计数。请拔下适配器再插上；若仍不行，请检查 CAN_H 和 CAN_L、波特率（{bitrate}）、终端电阻和机械臂的电源。</translation>
    </message>
    <message>
        <source>{channel} does not come back by itself from bus-off (restart-ms is 0).</source>
        <translation>{channel} 发生 bus off 后不会自动恢复（restart-ms 为 0）。</translation>
    </message>
    <message>
        <source>{channel}: the kernel has dropped {count} received frames since it was switched on; the computer was too busy.</source>
        <translation>{channel}：启用以来内核丢弃了 {count} 个接收报文，计算机过于繁忙。</translation>
    </message>
    <message>
        <source>Several adapters: {names}. Their names may swap at the next plugging in, and settings go to the wrong arm. Tell arms apart by the serial number, or give the adapters fixed names:</source>
        <translation>有多个适配器：{names}。重新插拔后名称可能互换，设置会发到错误的机械臂。请按序列号区分，或固定适配器名称：</translation>
    </message>
    <message>
        <source>{names} share one USB controller ({controller}): if it fails, all of them go at once. Spread them over ports of other controllers.</source>
        <translation>{names} 共用一个 USB 控制器（{controller}）：它一旦故障，它们会同时失效。请分散插到其他控制器的接口上。</translation>
    </message>
    <message>
        <source>There is no device to listen to. A simulated arm in another process is heard with --interface udp_multicast.</source>
        <translation>没有可监听的设备。另一进程中的仿真机械臂可用 --interface udp_multicast 监听。</translation>
    </message>
    <message>
        <source>{device}: the package {package} is missing.</source>
        <translation>{device}：缺少软件包 {package}。</translation>
    </message>
    <message>
        <source>{device}: the maker&apos;s driver is missing: {text}</source>
        <translation>{device}：缺少厂商驱动：{text}</translation>
    </message>
    <message>
        <source>{device} is not there (any more): {text}</source>
        <translation>{device} 不存在或已拔出：{text}</translation>
    </message>
    <message>
        <source>{device} is in use by another program. End that program, or listen there.</source>
        <translation>{device} 正被其他程序使用。请先关闭该程序。</translation>
    </message>
    <message>
        <source>{device} is switched off.</source>
        <translation>{device} 未启用。</translation>
    </message>
    <message>
        <source>{device} may not be opened by this user: {text}</source>
        <translation>当前用户无权打开 {device}：{text}</translation>
    </message>
    <message>
        <source>{device} cannot be opened with these settings: {text}</source>
        <translation>{device} 无法以这些参数打开：{text}</translation>
    </message>
    <message>
        <source>{device} cannot be opened: {text}</source>
        <translation>{device} 无法打开：{text}</translation>
    </message>
    <message>
        <source>{device} went off the bus (bus-off) while it was listened to: cable, terminating resistors, bit rate.</source>
        <translation>监听期间 {device} 离线（bus-off）：请检查电缆、终端电阻、波特率。</translation>
    </message>
    <message>
        <source>{device}: {count} error frames in {seconds} s. Bit rate other than the arm&apos;s, a loose plug, or no terminating resistor.</source>
        <translation>{device}：{seconds} s 内有 {count} 个错误帧。可能波特率与机械臂不符、插头松动或缺少终端电阻。</translation>
    </message>
    <message>
        <source>{device}: not one frame in {seconds} s. Is the arm switched on, the CAN cable plugged in, the bit rate 1000000? The arm may also be told to keep silent (0x422): a power cycle ends that.</source>
        <translation>{device}：{seconds} s 内没有收到任何报文。机械臂是否上电、CAN 线是否插好、波特率是否为 1000000？机械臂也可能被置为静默（0x422）：重新上电即可恢复。</translation>
    </message>
    <message>
        <source>{device} is deaf: it sends, hears not one frame, and reports no error. Unplug the adapter and plug it in again. If that does not help, check CAN_H and CAN_L, the bit rate, the terminating resistors (120 Ω), a receive filter of the adapter, and the arm&apos;s power.</source>
        <translation>{device} 收不到任何帧：能发送，却一帧也没听到，也不报错误。请拔下适配器再插上；若仍不行，请检查 CAN_H 和 CAN_L、波特率、终端电阻（120 Ω）、适配器的接收过滤器和机械臂的电源。</translation>
    </message>
    <message>
        <source>{device}: {count} frames in {seconds} s, but no feedback of an arm. Heard: {ids}.</source>
        <translation>{device}：{seconds} s 内收到 {count} 个报文，但没有机械臂反馈。收到：{ids}。</translation>
    </message>
    <message>
        <source>{device}: feedback is heard, but no question was answered: commands do not get through. Another offset of the commands (0x470), or an adapter that only listens.</source>
        <translation>{device}：能收到反馈，但询问没有应答：指令没有送达。可能是控制偏移不同（0x470），或适配器处于只听模式。</translation>
    </message>
    <message>
        <source>{device}: an arm of generation {generation}, {rate} frames/s.</source>
        <translation>{device}：第 {generation} 代协议的机械臂，{rate} 帧/s。</translation>
    </message>
    <message>
        <source>Firmware {firmware}{identity}.</source>
        <translation>固件 {firmware}{identity}。</translation>
    </message>
    <message>
        <source>The firmware&apos;s version was not heard: the arm tells it only when asked.</source>
        <translation>未收到固件版本：机械臂只在被询问时回答。</translation>
    </message>
    <message>
        <source>The maker recommends firmware S-V1.8-9 or later; {firmware} has known faults. Updates come from the maker&apos;s support.</source>
        <translation>厂家建议使用 S-V1.8-9 或更高版本固件；{firmware} 存在已知问题。更新请联系厂家支持。</translation>
    </message>
    <message>
        <source>Model by the pose it reports: {fits}.</source>
        <translation>按机械臂反馈的位姿判断，型号为 {fits}。</translation>
    </message>
    <message>
        <source>Connected as a {chosen}, but the pose it reports is that of a {fits}. Connect it as a {fits}: tool moves and checks would be wrong.</source>
        <translation>连接时选择的型号是 {chosen}，但其反馈的位姿属于 {fits}。请按 {fits} 重新连接：否则末端运动和检查会出错。</translation>
    </message>
    <message>
        <source>With {firmware} a joint may lose its reference without a fault: angles look right, the arm stands elsewhere. Compare the 3D picture with the arm; only stop and release (the arm drops) or a power cycle mends it.</source>
        <translation>{firmware} 的关节可能在没有报错的情况下丢失基准：角度看似正常，实际位置不同。请对照 3D 画面与机械臂；只有急停后解除（机械臂会下落）或重新上电才能修复。</translation>
    </message>
    <message>
        <source>The arm&apos;s feedback is shifted by {offset} (0x470): the program follows it by itself.</source>
        <translation>机械臂的反馈偏移为 {offset}（0x470）：程序会自动跟随。</translation>
    </message>
    <message>
        <source>{device}: a second arm is heard, its feedback shifted by {offsets}.</source>
        <translation>{device}：听到第二台机械臂，反馈偏移为 {offsets}。</translation>
    </message>
    <message>
        <source>{device}: the arm is a teaching-input arm: it leads others and takes no commands ({ids}). Make it a motion output again (0x470, 0xFC), then switch it off and on.</source>
        <translation>{device}：该机械臂为示教输入臂（主臂），不接受运动指令（{ids}）。请重新设为运动输出臂（0x470，0xFC），然后断电重启。</translation>
    </message>
    <message>
        <source>{device}: another program or host commands the arm: {frames}. End it before you move the arm from here.</source>
        <translation>{device}：另一程序或主机正在控制机械臂：{frames}。从本机控制之前请先停止它。</translation>
    </message>
    <message>
        <source>The arm&apos;s status (0x2A1) is not heard, though other feedback is.</source>
        <translation>收到了其他反馈，但没有收到机械臂状态（0x2A1）。</translation>
    </message>
    <message>
        <source>The arm is in emergency stop. Release drops the arm: hold it.</source>
        <translation>机械臂处于急停状态。解除急停时机械臂会下落：请扶住机械臂。</translation>
    </message>
    <message>
        <source>The arm reports {status}.</source>
        <translation>机械臂报告状态 {status}。</translation>
    </message>
    <message>
        <source>The arm is in {mode}: another program has set it. A new mode word leaves the joints limp and the arm falls.</source>
        <translation>机械臂处于 {mode}：由其他程序设置。切换模式会使关节失力，机械臂会下落。</translation>
    </message>
    <message>
        <source>Joint {joints}: no communication with the main controller. Switch the arm off and on; if it stays, the cable inside is at fault.</source>
        <translation>关节 {joints}：与主控制器通讯异常。请断电重启；若仍存在，则为内部线缆故障。</translation>
    </message>
    <message>
        <source>Joint {joints} is beyond its limit.</source>
        <translation>关节 {joints} 超出限位。</translation>
    </message>
    <message>
        <source>Drivers report: {faults}.</source>
        <translation>驱动器报告：{faults}。</translation>
    </message>
    <message>
        <source>The drivers see only {voltage} V; the supply should have 24 V. A supply that is too weak, or a long cable.</source>
        <translation>驱动器电压只有 {voltage} V，应为 24 V。电源功率不足或电缆过长。</translation>
    </message>
    <message>
        <source>The feedback is all zero: seen with a teaching level of 255 in 0x47E (S-V1.5-8). Make the arm a teaching input and a motion output again, and set the teaching level to 1 (0x47D).</source>
        <translation>反馈全部为零：0x47E 中示教等级为 255 时会出现（S-V1.5-8）。请将机械臂设为示教输入臂再改回，并把示教等级设为 1（0x47D）。</translation>
    </message>
    <message>
        <source>RY is {ry}°: near ±90° the three angles of the end pose jump by up to 360°. That is how they are, not a fault; never subtract them.</source>
        <translation>RY 为 {ry}°：接近 ±90° 时末端姿态角会跳变，最大 360°。这是欧拉角的特性，不是故障；不要对其做差。</translation>
    </message>
    <message>
        <source>Joint {joints}: the limits kept in the arm are damaged. Set joint limits, speeds and accelerations to factory values (0x477), then read and set each.</source>
        <translation>关节 {joints}：机械臂中保存的限位已损坏。请将关节限位、速度、加速度恢复出厂值（0x477），然后逐项读取并设置。</translation>
    </message>
    <message>
        <source>{name} has its name by its adapter&apos;s serial number, and is switched on at every start.</source>
        <translation>{name} 已按适配器序列号固定名称，每次启动时自动启用。</translation>
    </message>
    <message>
        <source>The package {package} is not installed; some adapters need it.</source>
        <translation>未安装软件包 {package}；部分适配器需要它。</translation>
    </message>
    <message>
        <source>A serial adapter ({name}) may be opened by whoever sits at this computer.</source>
        <translation>串口适配器（{name}）可由本机当前登录的用户打开。</translation>
    </message>
    <message>
        <source>This Linux is a guest of Windows (WSL): the adapter has to be handed over to it, before the arm is powered. In a terminal of Windows, with the adapter&apos;s BUSID from the list:</source>
        <translation>当前 Linux 运行在 Windows 的 WSL 中：请先把适配器交给 WSL，再给机械臂上电。在 Windows 终端中运行（BUSID 取自列表）：</translation>
    </message>
    <message>
        <source>The program is not whole: of its own packages, {package} is missing or another version ({installed}). Install armui once more, from the file it was installed from.</source>
        <translation>程序不完整：自带的软件包 {package} 缺失或版本不符（{installed}）。请用原安装文件重新安装 armui。</translation>
    </message>
    <message>
        <source>{device} needs the Python package {package}, which is no part of this installed program, and cannot be added to it. Use another adapter, or armui from its source with that package.</source>
        <translation>{device} 需要 Python 软件包 {package}，此安装版程序不含它，也无法添加。请换用其他适配器，或从源码运行 armui 并安装该软件包。</translation>
    </message>
</context>
<context>
    <name>DialectBar</name>
    <message>
        <source>Encoding</source>
        <translation>编码</translation>
    </message>
    <message>
        <source>Delimiter</source>
        <translation>分隔符</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>小数点</translation>
    </message>
    <message>
        <source>Figures from line</source>
        <translation>数据起始行</translation>
    </message>
    <message>
        <source>The line above holds the column titles if it has as many cells</source>
        <translation>上一行的单元格数与列数相同时，作为列标题</translation>
    </message>
    <message>
        <source>comma ,</source>
        <translation>逗号 ,</translation>
    </message>
    <message>
        <source>semicolon ;</source>
        <translation>分号 ;</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>制表符</translation>
    </message>
    <message>
        <source>vertical bar |</source>
        <translation>竖线 |</translation>
    </message>
    <message>
        <source>spaces</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>point .</source>
        <translation>点 .</translation>
    </message>
</context>
<context>
    <name>Disabling</name>
    <message>
        <source>From firmware S-V1.9-0 on the gripper lets go, too, and what it holds falls. To keep it, disable joints 1–6 singly.</source>
        <translation>固件 S-V1.9-0 起夹爪也会松开，所夹之物会掉落。要继续夹住，请逐个失能关节 1–6。</translation>
    </message>
    <message>
        <source>The gripper lets go, too, and what it holds falls. To keep it, disable joints 1–6 singly.</source>
        <translation>夹爪也会松开，所夹之物会掉落。要继续夹住，请逐个失能关节 1–6。</translation>
    </message>
</context>
<context>
    <name>DoctorDialog</name>
    <message>
        <source>Diagnosis</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Copy report</source>
        <translation>复制报告</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>重新诊断</translation>
    </message>
    <message>
        <source>Only looked and listened: nothing was sent. In a terminal: armui doctor</source>
        <translation>仅查看和监听，没有发送任何报文。终端命令：armui doctor</translation>
    </message>
    <message>
        <source>The diagnosis is running.</source>
        <translation>正在诊断。</translation>
    </message>
    <message>
        <source>There is no report yet.</source>
        <translation>还没有报告。</translation>
    </message>
    <message>
        <source>Looking at this computer, its CAN devices and the bus…</source>
        <translation>正在检查本机、CAN 设备和总线…</translation>
    </message>
    <message>
        <source>The diagnosis failed: {text}</source>
        <translation>诊断失败：{text}</translation>
    </message>
    <message>
        <source>Faults: {faults}, warnings: {warnings}</source>
        <translation>故障 {faults} 项，注意 {warnings} 项</translation>
    </message>
    <message>
        <source>No fault was found.</source>
        <translation>没有发现故障。</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>报告问题…</translation>
    </message>
</context>
<context>
    <name>DoctorReport</name>
    <message>
        <source>Listened only: nothing was sent.</source>
        <translation>仅监听：没有发送任何报文。</translation>
    </message>
    <message>
        <source>Questions were sent to the arm (--ask): they move and change nothing.</source>
        <translation>已向机械臂发送询问报文（--ask）：不会引起运动，也不会更改设置。</translation>
    </message>
    <message>
        <source>An arm answers.</source>
        <translation>机械臂有应答。</translation>
    </message>
    <message>
        <source>No arm answers.</source>
        <translation>没有机械臂应答。</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>CAN devices</source>
        <translation>CAN 设备</translation>
    </message>
    <message>
        <source>Bus and arm</source>
        <translation>总线与机械臂</translation>
    </message>
    <message>
        <source>[ ok ]</source>
        <translation>[正常]</translation>
    </message>
    <message>
        <source>[note]</source>
        <translation>[提示]</translation>
    </message>
    <message>
        <source>[warn]</source>
        <translation>[注意]</translation>
    </message>
    <message>
        <source>[FAIL]</source>
        <translation>[故障]</translation>
    </message>
</context>
<context>
    <name>DragAssistancePanel</name>
    <message>
        <source>Drag assistance</source>
        <translation>拖动助力</translation>
    </message>
    <message>
        <source>0: the joint does not help the hand; 10: it helps most. Read and set with the arm at rest; keep a hand on it when you lead it for the first time afterwards.</source>
        <translation>0 表示该关节不助力，10 表示助力最大。请在机械臂静止时读取和设置；更改后首次拖动时请始终用手扶住机械臂。</translation>
    </message>
</context>
<context>
    <name>Drawer</name>
    <message>
        <source>Moves this page into its own window, for a second screen.</source>
        <translation>把本页移到独立窗口，例如放到第二块屏幕上。</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>独立窗口</translation>
    </message>
    <message>
        <source>Fold away</source>
        <translation>收起</translation>
    </message>
    <message>
        <source>Folds the drawer away (Esc)</source>
        <translation>收起抽屉 (Esc)</translation>
    </message>
</context>
<context>
    <name>DropStrip</name>
    <message>
        <source>Drag a quantity into a plot, or here for a plot of its own</source>
        <translation>将量拖入图中，或拖到此处新建一张图</translation>
    </message>
</context>
<context>
    <name>EditorAction</name>
    <message>
        <source>Insert before</source>
        <translation>在上方插入</translation>
    </message>
    <message>
        <source>Insert after</source>
        <translation>在下方插入</translation>
    </message>
    <message>
        <source>Insert current pose</source>
        <translation>插入当前位姿</translation>
    </message>
    <message>
        <source>Replace with current pose</source>
        <translation>替换为当前位姿</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制一份</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Convert joint angles ↔ pose</source>
        <translation>关节角 ↔ 位姿互换</translation>
    </message>
    <message>
        <source>User frame…</source>
        <translation>用户坐标系…</translation>
    </message>
    <message>
        <source>Go to this point</source>
        <translation>运动到该点</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Find and replace</source>
        <translation>查找与替换</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
</context>
<context>
    <name>EditorHint</name>
    <message>
        <source>Insert current pose</source>
        <translation>插入当前位姿</translation>
    </message>
    <message>
        <source>Enter a point</source>
        <translation>手动输入一点</translation>
    </message>
    <message>
        <source>No points yet</source>
        <translation>还没有点</translation>
    </message>
    <message>
        <source>Bring the arm to the first point, by the jog buttons or by hand, and insert where it is. Or enter a point as figures. Then the next one.</source>
        <translation>用点动按钮或用手把机械臂带到第一个点，再插入当前位姿；也可以直接输入数值。</translation>
    </message>
</context>
<context>
    <name>EditorJog</name>
    <message>
        <source>Insert current pose</source>
        <translation>插入当前位姿</translation>
    </message>
    <message>
        <source>Inserts the arm&apos;s present pose as a point after the selected row.</source>
        <translation>在所选行之后，把机械臂当前位姿插入为一个点。</translation>
    </message>
</context>
<context>
    <name>EditorPage</name>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的修改</translation>
    </message>
    <message>
        <source>These changes were not saved when the program ended. Save them, or undo them.</source>
        <translation>程序结束时这些更改未保存。请保存，或撤销。</translation>
    </message>
    <message>
        <source>The tool has changed: the figure that was being typed is not taken.</source>
        <translation>工具已更换：正在输入的数值未采用。</translation>
    </message>
    <message>
        <source>An entry in row {row} was not taken: {reason}</source>
        <translation>第 {row} 行的输入未被采用：{reason}</translation>
    </message>
    <message>
        <source>The table is not what runs: the run goes by the points as they were when it began. No row is marked.</source>
        <translation>表格与正在运行的轨迹不一致：运行仍按开始时的轨迹点进行，不标示任何行。</translation>
    </message>
    <message>
        <source>Ended at row {row}. {reason}</source>
        <translation>在第 {row} 行结束。{reason}</translation>
    </message>
    <message>
        <source>Ended at row {row} of the table as it was. {reason} {changed}</source>
        <translation>在原表格的第 {row} 行结束。{reason}{changed}</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>已保存。</translation>
    </message>
    <message>
        <source>Working on {count} rows…</source>
        <translation>正在处理 {count} 行…</translation>
    </message>
    <message>
        <source>Not pasted. {reason}</source>
        <translation>未粘贴。{reason}</translation>
    </message>
    <message>
        <source>the base</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>“{lost}” is not known: the figures stayed, and count from {frame} now. The points are elsewhere then: check them, or undo.</source>
        <translation>“{lost}”的位置未知：数值保持不变，现在以{frame}为基准。点的位置因此改变：请检查，或撤销。</translation>
    </message>
    <message>
        <source>The points stay where they are; their figures are in {frame} now.</source>
        <translation>点的位置保持不变；数值现在以{frame}为基准。</translation>
    </message>
    <message>
        <source>Pasted as poses of {tool}, as the table shows them. Undo if they are of the flange or another tool.</source>
        <translation>已按{tool}的位姿粘贴，与表中一致。如果它们是法兰或其他工具的位姿，请撤销。</translation>
    </message>
    <message>
        <source>All is saved.</source>
        <translation>已全部保存。</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>没有可撤销的操作。</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>没有可重做的操作。</translation>
    </message>
    <message>
        <source>What this trajectory is for</source>
        <translation>该轨迹的用途</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>轨迹点</translation>
    </message>
    <message>
        <source>Saved. Another program had changed “{name}” since it was opened here: what it saved is in the library under “Recently deleted…”.</source>
        <translation>已保存。“{name}”在此处打开后被另一程序修改过：其保存的内容可在轨迹库的“最近删除…”中找到。</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>“{name}” has been saved since these unsaved changes were kept: they are not put over it. They are in the library under “Recently deleted…”.</source>
        <translation>“{name}”在这些未保存的更改之后又保存过：未用它们覆盖，可在轨迹库的“最近删除…”中找回。</translation>
    </message>
    <message>
        <source>These points were taught on another arm: {pasted}. Those here were taught on {here}. The same joint angles may hold the tool elsewhere: check them, or undo.</source>
        <translation>这些点在另一种机械臂上示教：{pasted}。此轨迹在 {here} 上示教。相同的关节角可能使工具处于别处：请检查，或撤销。</translation>
    </message>
    <message>
        <source>The angles count from the zeros of {arm} now; poses stay as they are. Save it, or undo it.</source>
        <translation>关节角现在以 {arm} 的零点计；位姿保持不变。请保存或撤销。</translation>
    </message>
</context>
<context>
    <name>EnableButton</name>
    <message>
        <source>Enabling…</source>
        <translation>使能中…</translation>
    </message>
    <message>
        <source>Disabling…</source>
        <translation>失能中…</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Partly enabled</source>
        <translation>部分使能</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>已失能</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已急停</translation>
    </message>
    <message>
        <source>Disable…</source>
        <translation>失能…</translation>
    </message>
    <message>
        <source>Fault: {joints}</source>
        <translation>故障：{joints}</translation>
    </message>
</context>
<context>
    <name>EndLimitsPanel</name>
    <message>
        <source>End speed limits</source>
        <translation>配速设置</translation>
    </message>
    <message>
        <source>Factory limits for the end</source>
        <translation>末端恢复出厂值</translation>
    </message>
    <message>
        <source>The greatest speeds and accelerations of the end become what they were when the arm left the factory: straight lines and arcs may run faster than they do now.</source>
        <translation>末端的最大速度和加速度将恢复为出厂值：直线和圆弧运动可能比现在更快。</translation>
    </message>
</context>
<context>
    <name>EndLoad</name>
    <message>
        <source>No load</source>
        <translation>空载</translation>
    </message>
    <message>
        <source>Half load</source>
        <translation>半载</translation>
    </message>
    <message>
        <source>Full load</source>
        <translation>满载</translation>
    </message>
    <message>
        <source>Not given</source>
        <translation>未设置</translation>
    </message>
</context>
<context>
    <name>EndLoadPanel</name>
    <message>
        <source>The arm reports</source>
        <translation>机械臂正在上报</translation>
    </message>
    <message>
        <source>Not heard</source>
        <translation>未收到</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>开启</translation>
    </message>
    <message>
        <source>Tells the arm its load, so that it compensates for the weight.</source>
        <translation>告知机械臂末端负载，以便其补偿重量。</translation>
    </message>
    <message>
        <source>Switches the periodic frames 0x481–0x486.</source>
        <translation>开启或关闭 0x481–0x486 周期反馈。</translation>
    </message>
    <message>
        <source>End load</source>
        <translation>末端负载</translation>
    </message>
    <message>
        <source>The arm acknowledges this setting, but cannot be asked for it afterwards.</source>
        <translation>机械臂会应答此设置，但之后无法查询。</translation>
    </message>
    <message>
        <source>Speed and acceleration of the end, by joint</source>
        <translation>各关节末端速度/加速度</translation>
    </message>
    <message>
        <source>Set load</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Linear speed</source>
        <translation>线速度</translation>
    </message>
    <message>
        <source>Angular speed</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>Linear acceleration</source>
        <translation>线加速度</translation>
    </message>
    <message>
        <source>Angular acceleration</source>
        <translation>角加速度</translation>
    </message>
</context>
<context>
    <name>EventBar</name>
    <message>
        <source>{shown} of {kept}</source>
        <translation>{shown} / {kept}</translation>
    </message>
    <message>
        <source>{count} kinds</source>
        <translation>{count} 类</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Every level</source>
        <translation>全部级别</translation>
    </message>
    <message>
        <source>Warnings and faults</source>
        <translation>警告和故障</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>All sources</source>
        <translation>全部来源</translation>
    </message>
    <message>
        <source>Who asked for it, or reports it</source>
        <translation>发起方或来源</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随最新</translation>
    </message>
    <message>
        <source>Keep the newest event in sight</source>
        <translation>始终显示最新的事件</translation>
    </message>
    <message>
        <source>Shown events as CSV…</source>
        <translation>所示事件存为 CSV…</translation>
    </message>
    <message>
        <source>Shown events as JSON…</source>
        <translation>所示事件存为 JSON…</translation>
    </message>
    <message>
        <source>Shown events as text…</source>
        <translation>所示事件存为文本…</translation>
    </message>
    <message>
        <source>Copy shown events</source>
        <translation>复制所示事件</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>全部类别</translation>
    </message>
</context>
<context>
    <name>EventColumn</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>回读</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>次数</translation>
    </message>
</context>
<context>
    <name>EventExport</name>
    <message>
        <source>Save the events</source>
        <translation>保存事件</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
</context>
<context>
    <name>EventKind</name>
    <message>
        <source>Command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Other host</source>
        <translation>其他程序</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
</context>
<context>
    <name>EventPage</name>
    <message>
        <source>Show in the curves</source>
        <translation>在曲线中显示</translation>
    </message>
    <message>
        <source>Show its end in the curves</source>
        <translation>在曲线中显示其结束</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Only this kind</source>
        <translation>仅此类别</translation>
    </message>
    <message>
        <source>Only this source</source>
        <translation>仅此来源</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Double-click: show the moment in the curves</source>
        <translation>双击：在曲线中显示该时刻</translation>
    </message>
</context>
<context>
    <name>EventTable</name>
    <message>
        <source>{begin} until {end} ({duration})</source>
        <translation>{begin} 至 {end}（{duration}）</translation>
    </message>
    <message>
        <source>; its end was not heard</source>
        <translation>；未收到其结束</translation>
    </message>
    <message>
        <source>since {begin}</source>
        <translation>自 {begin} 起</translation>
    </message>
    <message>
        <source>{count} times, the last at {last}</source>
        <translation>共 {count} 次，最近一次 {last}</translation>
    </message>
    <message>
        <source>Answer after {seconds} s: {text}</source>
        <translation>{seconds} s 后应答：{text}</translation>
    </message>
    <message>
        <source>Read back after {seconds} s: {text}</source>
        <translation>{seconds} s 后回读：{text}</translation>
    </message>
    <message>
        <source>ongoing</source>
        <translation>持续中</translation>
    </message>
    <message>
        <source>not heard</source>
        <translation>未收到</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export a log</source>
        <translation>导出日志</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>{target} exists already. It is replaced once the export is complete.</source>
        <translation>{target} 已存在。导出完整写好后才会替换它。</translation>
    </message>
    <message>
        <source>Replace the file?</source>
        <translation>替换文件？</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>An export is under way.</source>
        <translation>正在导出。</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>取消导出</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The export was cancelled; nothing was written.</source>
        <translation>导出已取消，没有写入任何文件。</translation>
    </message>
    <message>
        <source>Exporting… {frames:,} frames read</source>
        <translation>正在导出… 已读取 {frames:,} 帧</translation>
    </message>
    <message>
        <source>ROS 2 messages: joint states, targets, end pose, transforms of the links, diagnostics. For Foxglove, PlotJuggler, rerun and ROS 2 itself.</source>
        <translation>ROS 2 消息：关节状态、目标、末端位姿、各连杆变换、诊断。可用 Foxglove、PlotJuggler、rerun、ROS 2 打开。</translation>
    </message>
    <message>
        <source>A table as text: a row for each set of joint angles, all else as last heard then. For spreadsheets and scripts.</source>
        <translation>文本表格：每收到一组关节角度为一行，其余各列为当时最近收到的值。适用于电子表格和脚本。</translation>
    </message>
    <message>
        <source>A dataset to learn from: the marked episodes at 30 frames a second, without images. What is left out is said. For LeRobot 0.6; needs the package pyarrow.</source>
        <translation>供学习的数据集：标记的片段，每秒 30 帧，不含图像。略去的部分会说明。用于 LeRobot 0.6；需要 pyarrow 软件包。</translation>
    </message>
    <message>
        <source>The same table with types and units, small and quick to open. For pandas and the like; needs the package pyarrow.</source>
        <translation>同一表格，带类型和单位，文件小、打开快。适用于 pandas 等工具；需要安装 pyarrow 包。</translation>
    </message>
    <message>
        <source>The log cannot be read: {detail}</source>
        <translation>无法读取该日志：{detail}</translation>
    </message>
    <message>
        <source>The log has no such channel. It has: {detail}</source>
        <translation>日志中没有此通道。现有通道：{detail}</translation>
    </message>
    <message>
        <source>The log has no frames. No file was written.</source>
        <translation>日志中没有任何帧。未写入文件。</translation>
    </message>
    <message>
        <source>No frame of the log is an arm&apos;s. No file was written. Another channel?</source>
        <translation>日志中没有机械臂的帧。未写入文件。是否应选择其他通道？</translation>
    </message>
    <message>
        <source>A table has a row for each set of joint angles, and none was heard. No file was written. MCAP holds what else there is.</source>
        <translation>表格中每组关节角度为一行，而日志中没有关节角度。未写入文件。其余内容可导出为 MCAP。</translation>
    </message>
    <message>
        <source>Nothing was heard in this time. No file was written.</source>
        <translation>此时间段内没有收到任何内容。未写入文件。</translation>
    </message>
    <message>
        <source>{target} exists already.</source>
        <translation>{target} 已存在。</translation>
    </message>
    <message>
        <source>The target is the log itself. Choose another name.</source>
        <translation>目标文件就是日志本身，请换一个名称。</translation>
    </message>
    <message>
        <source>{target} cannot be written: {detail}</source>
        <translation>无法写入 {target}：{detail}</translation>
    </message>
    <message>
        <source>Parquet needs the package pyarrow: pip install &apos;armui[parquet]&apos;. CSV has the same table without it.</source>
        <translation>Parquet 需要 pyarrow 包：pip install &apos;armui[parquet]&apos;。CSV 无需它，内容是同一表格。</translation>
    </message>
    <message>
        <source>In no second of it were the angles heard and the arm without a fault. No dataset was written.</source>
        <translation>其中没有任何一秒既收到关节角度、机械臂又无故障。未写入数据集。</translation>
    </message>
    <message>
        <source>The export failed: {detail}</source>
        <translation>导出失败：{detail}</translation>
    </message>
    <message>
        <source>Saved: {target} ({items:,} rows)</source>
        <translation>已保存：{target}（{items:,} 行）</translation>
    </message>
    <message>
        <source>Saved: {target} ({items:,} messages)</source>
        <translation>已保存：{target}（{items:,} 条消息）</translation>
    </message>
    <message>
        <source>Saved: {target} ({items:,} frames)</source>
        <translation>已保存：{target}（{items:,} 帧）</translation>
    </message>
    <message>
        <source>Only channel {channel} was exported; {count:,} frames of {others} were left out.</source>
        <translation>只导出了通道 {channel}；{others} 的 {count:,} 帧未导出。</translation>
    </message>
    <message>
        <source>A folder with a file for each message: every frame with its time, decoded into signals with their units.</source>
        <translation>一个文件夹，每种报文一个文件：每一帧带时间，解码为带单位的信号。</translation>
    </message>
    <message>
        <source>Unreadable places in the log: {count}; the first: {place} ({reason}). Everything else was exported.</source>
        <translation>日志中有 {count} 处无法读取，第一处：{place}（{reason}）。其余内容均已导出。</translation>
    </message>
    <message>
        <source>{count:,} of them do not belong to the arm.</source>
        <translation>其中 {count:,} 帧不属于该机械臂。</translation>
    </message>
    <message>
        <source>Exported as a {model}, but the end pose in the log fits a {fits}.</source>
        <translation>已按 {model} 导出，但日志中的末端位姿与 {fits} 相符。</translation>
    </message>
    <message>
        <source>{frames:,} frames read as generation {generation}, {model}.</source>
        <translation>共 {frames:,} 帧，按第 {generation} 代协议读取，型号 {model}。</translation>
    </message>
    <message>
        <source>{count:,} are questions of this program or another host.</source>
        <translation>{count:,} 帧为本程序或其他程序的查询。</translation>
    </message>
</context>
<context>
    <name>ExportForm</name>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间段</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标文件</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the target</source>
        <translation>选择目标文件</translation>
    </message>
    <message>
        <source>As found in the log</source>
        <translation>按日志判断</translation>
    </message>
    <message>
        <source>Generation 1</source>
        <translation>第 1 代</translation>
    </message>
    <message>
        <source>Generation 2</source>
        <translation>第 2 代</translation>
    </message>
    <message>
        <source>As in the log</source>
        <translation>按日志内容</translation>
    </message>
    <message>
        <source>Where the links and the tool are depends on it. A log of this program says it; of other logs it is the one that fits the end pose in them.</source>
        <translation>连杆与工具的位置取决于型号。本程序的日志中已注明；其他日志取与其中末端位姿相符的型号。</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>counted from the first frame</source>
        <translation>从第一帧起计</translation>
    </message>
    <message>
        <source>beginning</source>
        <translation>开头</translation>
    </message>
    <message>
        <source>end</source>
        <translation>结尾</translation>
    </message>
    <message>
        <source>From, in seconds from the first frame</source>
        <translation>起点，从第一帧起的秒数</translation>
    </message>
    <message>
        <source>Up to, in seconds from the first frame</source>
        <translation>终点，从第一帧起的秒数</translation>
    </message>
    <message>
        <source>the one on which an arm is heard</source>
        <translation>有机械臂数据的通道</translation>
    </message>
    <message>
        <source>beside the log</source>
        <translation>与日志同一文件夹</translation>
    </message>
    <message>
        <source>The time must begin at 0 s or later, and end after that.</source>
        <translation>起点不得小于 0 秒，终点须大于起点。</translation>
    </message>
    <message>
        <source>CAN log</source>
        <translation>CAN 日志</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>CSV per message</source>
        <translation>CSV（按报文）</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Choose the log</source>
        <translation>选择日志</translation>
    </message>
    <message>
        <source>Choose the log first.</source>
        <translation>请先选择日志。</translation>
    </message>
    <message>
        <source>Choose where to put the folder of the export</source>
        <translation>选择导出文件夹的位置</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>型号</translation>
    </message>
</context>
<context>
    <name>FailureLine</name>
    <message>
        <source>It has happened {count} times.</source>
        <translation>已出现 {count} 次。</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>复制详细信息</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>An error in the program ({error}). The emergency stop works; every motion of this program has been ended. Copy the details for the developers.</source>
        <translation>程序内部出错（{error}）。急停仍然有效；本程序的所有运动均已结束。请复制详细信息交给开发者。</translation>
    </message>
    <message>
        <source>An error in the program ({error}). The emergency stop works; the part that failed can move nothing, and no motion was ended. Copy the details for the developers.</source>
        <translation>程序内部出错（{error}）。急停仍然有效；出错部分不驱动任何运动，因此未结束运动。请复制详细信息交给开发者。</translation>
    </message>
</context>
<context>
    <name>FaultsDialog</name>
    <message>
        <source>Simulated faults</source>
        <translation>仿真故障</translation>
    </message>
    <message>
        <source>At joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Of the arm and its bus</source>
        <translation>整臂与总线</translation>
    </message>
    <message>
        <source>Pressed, a fault begins; pressed again, it ends.</source>
        <translation>按下开始故障，再按一次结束。</translation>
    </message>
    <message>
        <source>On: {faults}</source>
        <translation>进行中：{faults}</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Joint number</source>
        <translation>关节序号</translation>
    </message>
    <message>
        <source>Lamp number</source>
        <translation>灯珠序号</translation>
    </message>
    <message>
        <source>R channel</source>
        <translation>R 通道</translation>
    </message>
    <message>
        <source>G channel</source>
        <translation>G 通道</translation>
    </message>
    <message>
        <source>B channel</source>
        <translation>B 通道</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>开度</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Height over the floor, mm</source>
        <translation>距地面高度，mm</translation>
    </message>
</context>
<context>
    <name>FileDialog</name>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
</context>
<context>
    <name>FileExport</name>
    <message>
        <source>Not saved: {path}. {reason}</source>
        <translation>未保存：{path}。{reason}</translation>
    </message>
    <message>
        <source>Saved: {path}</source>
        <translation>已保存：{path}</translation>
    </message>
</context>
<context>
    <name>FilePlace</name>
    <message>
        <source>{file}, line {line}, column {column}: {reason}</source>
        <translation>{file}，第 {line} 行，第 {column} 列：{reason}</translation>
    </message>
    <message>
        <source>{file}, line {line}: {reason}</source>
        <translation>{file}，第 {line} 行：{reason}</translation>
    </message>
    <message>
        <source>{file}: {reason}</source>
        <translation>{file}：{reason}</translation>
    </message>
    <message>
        <source>Line {line}, column {column}: {reason}</source>
        <translation>第 {line} 行，第 {column} 列：{reason}</translation>
    </message>
    <message>
        <source>Line {line}: {reason}</source>
        <translation>第 {line} 行：{reason}</translation>
    </message>
</context>
<context>
    <name>FilterBar</name>
    <message>
        <source>Identifiers in hexadecimal: 2A1, 2A1-2A8, or value/mask as in 150/7F0</source>
        <translation>十六进制 ID：2A1、2A1-2A8，或“值/掩码”，例如 150/7F0</translation>
    </message>
    <message>
        <source>“{value}” is not an identifier; the filter is unchanged.</source>
        <translation>“{value}”不是 ID；筛选保持不变。</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>By ID</source>
        <translation>按 ID</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>按时间</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Only unknown</source>
        <translation>仅未知或异常的</translation>
    </message>
    <message>
        <source>Freezes the figures; frames that come meanwhile are still counted</source>
        <translation>数值停在当前；期间到达的帧仍会统计</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Starts counting from zero</source>
        <translation>从零重新统计</translation>
    </message>
    <message>
        <source>Name or identifier</source>
        <translation>名称或 ID</translation>
    </message>
    <message>
        <source>Identifiers</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Frames that are not known, or not as they should be</source>
        <translation>未知的报文，以及长度或内容不符的报文</translation>
    </message>
    <message>
        <source>Only changed</source>
        <translation>仅变化的</translation>
    </message>
    <message>
        <source>Frames of which a byte has changed since this was ticked</source>
        <translation>勾选以后有字节变化的帧</translation>
    </message>
    <message>
        <source>All senders</source>
        <translation>所有发送方</translation>
    </message>
    <message>
        <source>Sender</source>
        <translation>发送方</translation>
    </message>
</context>
<context>
    <name>FindBar</name>
    <message>
        <source>Type what to find first.</source>
        <translation>请先输入要查找的内容。</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>停留</translation>
    </message>
    <message>
        <source>Where to search</source>
        <translation>查找范围</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>替换为</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一个</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>全部替换</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>Finder</name>
    <message>
        <source>Not found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>{place} of {count}</source>
        <translation>第 {place} 处，共 {count} 处</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>{count} replaced</source>
        <translation>已替换 {count} 处</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>There is nothing to run. Add points, or record.</source>
        <translation>没有可执行的内容。请添加轨迹点，或重新录制。</translation>
    </message>
    <message>
        <source>On the way joint {joint} would come to {value}°, beyond its limits {minimum}° to {maximum}°. Put another point between, or use MOVE J.</source>
        <translation>途中关节 {joint} 将到 {value}°，超出限位 {minimum}° 至 {maximum}°。请在中间增加一点，或改用 MOVE J。</translation>
    </message>
    <message>
        <source>Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. The replay goes at {percent} % at most.</source>
        <translation>关节 {joint} 需以 {value}°/s 转动，其上限为 {maximum}°/s。回放速度最高 {percent} %。</translation>
    </message>
    <message>
        <source>After {gone} % of the way the tool would be out of reach. Put another point between, or use MOVE J.</source>
        <translation>走完 {gone} % 后末端将超出工作范围。请在中间增加一点，或改用 MOVE J。</translation>
    </message>
    <message>
        <source>After {gone} % of the way joint {joint} would have to leap: the arm is in a singular pose there. Put another point between, or use MOVE J.</source>
        <translation>走完 {gone} % 后关节 {joint} 需要突变：该处为奇异点。请在中间增加一点，或改用 MOVE J。</translation>
    </message>
    <message>
        <source>The point before, the middle and the end lie on one line or coincide: that is no arc. Move the middle aside, or use MOVE L.</source>
        <translation>上一点、中间点和终点共线或重合，不能构成圆弧。请移开中间点，或改用 MOVE L。</translation>
    </message>
    <message>
        <source>This would begin where row {before} ends, and the arm does not come there. Change row {before} first.</source>
        <translation>本点应从第 {before} 行的终点开始，但机械臂到不了那里。请先修改第 {before} 行。</translation>
    </message>
    <message>
        <source>The point is in the user frame “{name}”, which the cell does not have: its place is unknown. Choose the cell that has it, or make a frame of this name under Cell.</source>
        <translation>该点位于用户坐标系“{name}”中，而当前单元没有这个坐标系，无法确定其位置。请选择含有该坐标系的单元，或在“单元”中新建同名坐标系。</translation>
    </message>
    <message>
        <source>Joint {joint} would be at {value}°, beyond its limits {minimum}° to {maximum}°.</source>
        <translation>关节 {joint} 将到 {value}°，超出限位 {minimum}° 至 {maximum}°。</translation>
    </message>
    <message>
        <source>Change the point.</source>
        <translation>请修改该点。</translation>
    </message>
    <message>
        <source>The arm would hit itself: {other} against {one}.</source>
        <translation>机械臂将碰到自身：{other}与{one}。</translation>
    </message>
    <message>
        <source>Put another point between, or change the point.</source>
        <translation>请在中间增加一点，或修改该点。</translation>
    </message>
    <message>
        <source>Its first {seconds} s lie outside the limits, as an arm does at rest: it is replayed from here on.</source>
        <translation>开头 {seconds} s 位于限位之外，如同静置的机械臂：将从此处开始回放。</translation>
    </message>
    <message>
        <source>Its last {seconds} s lie outside the limits, as an arm does at rest: it is replayed up to here.</source>
        <translation>最后 {seconds} s 位于限位之外，如同静置的机械臂：只回放到此处。</translation>
    </message>
    <message>
        <source>{joints} outside the limits, as an arm lies at rest: it is led just inside them instead.</source>
        <translation>{joints} 位于限位之外，如同静置的机械臂：改为移动到限位之内。</translation>
    </message>
    <message>
        <source>The gripper would have to open {value} mm; it opens {maximum} mm at most. Enter less.</source>
        <translation>夹爪需要张开 {value} mm，最大行程为 {maximum} mm。请改小。</translation>
    </message>
    <message>
        <source>The way passes near a singular pose ({value}, should be {minimum} or more): joints turn fast there and the tool is slow. Use MOVE J, or turn the wrist.</source>
        <translation>路径经过奇异点附近（{value}，应不小于 {minimum}）：该处关节转动快而末端缓慢。请改用 MOVE J，或改变手腕姿态。</translation>
    </message>
    <message>
        <source>Too near to “{name}” of the work area: {part} would come to {value} mm, where {minimum} mm are kept.</source>
        <translation>离工作区的“{name}”太近：{part}将到 {value} mm，应保持 {minimum} mm。</translation>
    </message>
    <message>
        <source>The tool or what is held would be {value} mm below the floor. Accept this only if there is nothing.</source>
        <translation>末端或工件将低于地面 {value} mm。确认下方没有物体时才可接受。</translation>
    </message>
    <message>
        <source>The first point is far from where the arm is: joint {joint} turns {value}°. Watch the way there in the preview, or bring the arm nearer first.</source>
        <translation>第一点离机械臂当前位置较远：关节 {joint} 要转 {value}°。请在预览中查看这段路径，或先把机械臂移近。</translation>
    </message>
    <message>
        <source>Joint {joint} turns {value}° to hold this pose. If that is not meant, give the point as joint angles.</source>
        <translation>到达该位姿时关节 {joint} 要转 {value}°。如非本意，请改用关节角度表示该点。</translation>
    </message>
    <message>
        <source>From here on the gripper holds “{name}”, which the cell does not have: its size is unknown. Choose the cell that has it, or add it under Cell, Held.</source>
        <translation>从该点起夹爪夹着“{name}”，而当前单元没有这个工件，无法确定其大小。请选择含有该工件的单元，或在“单元”的“工件”中添加。</translation>
    </message>
    <message>
        <source>Joint {joint} jumps {value}° from the sample before. Trim the recording there, or record again.</source>
        <translation>关节 {joint} 与上一采样相差 {value}°。请在此处裁剪，或重新录制。</translation>
    </message>
    <message>
        <source>The tool would go at {value} mm/s; its limit is {maximum} mm/s, and the arm does not keep it here by itself. Lower the speed.</source>
        <translation>末端速度将达 {value} mm/s，上限为 {maximum} mm/s，此处机械臂不会自行限速。请降低速度。</translation>
    </message>
    <message>
        <source>The tool or what is held would come to {value} mm; motions end at {minimum} mm, as chosen under Settings.</source>
        <translation>末端或工件将到达 {value} mm；按“设置”中的选择，运动止于 {minimum} mm。</translation>
    </message>
    <message>
        <source>The flange cannot get there: the point is {missing} mm too far. Move it nearer.</source>
        <translation>法兰无法到达该位置：还差 {missing} mm。请把该点移近。</translation>
    </message>
    <message>
        <source>On the way there from where the arm stands now: {text} Bringing the arm nearer to this point first helps, too.</source>
        <translation>从机械臂当前位置到该点的途中：{text}也可以先让机械臂靠近该点。</translation>
    </message>
    <message>
        <source>Each of the first {cycles} cycles takes another way than those before, so that the next ones cannot be checked. Give one of the points as joint angles (MOVE J), or run fewer cycles.</source>
        <translation>前 {cycles} 次循环的路径各不相同，之后的循环无法检查。请将其中一点改用关节角度（MOVE J），或减少循环次数。</translation>
    </message>
    <message>
        <source>The arc begins with joint {joint} at its limit ({value}°): the arm may not find its way there again. End the point before a little further in, or use MOVE L.</source>
        <translation>圆弧起点处关节 {joint} 位于限位（{value}°）：机械臂可能无法再求得该位姿的解。请让上一点离限位稍远，或改用 MOVE L。</translation>
    </message>
    <message>
        <source>Two ways to hold this pose are about equally near: joint {joint} at {value}°, which was checked, or at {other}°. Give the point as joint angles, so that it is certain which.</source>
        <translation>到达该位姿有两种远近相当的姿态：关节 {joint} 为 {value}°（已检查）或 {other}°。请改用关节角度表示该点，以确定采用哪一种。</translation>
    </message>
    <message>
        <source>This was taught on another arm: {taught}; connected is {arm}. The same joint angles may hold the tool elsewhere. It was checked for {arm}, and nothing was converted. Watch the preview before you accept this.</source>
        <translation>此轨迹在另一种机械臂上示教：{taught}；当前为 {arm}。同样的关节角可能使末端在别处。已按 {arm} 检查，未做任何换算。请先看预览再接受。</translation>
    </message>
</context>
<context>
    <name>FindingCycle</name>
    <message>
        <source>From cycle {cycle} on: {text}</source>
        <translation>从第 {cycle} 次循环起：{text}</translation>
    </message>
</context>
<context>
    <name>FindingRow</name>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Switch on: {bitrate}</source>
        <translation>启用：{bitrate}</translation>
    </message>
    <message>
        <source>Bring back to the bus</source>
        <translation>恢复总线</translation>
    </message>
    <message>
        <source>Forget…</source>
        <translation>不再保留…</translation>
    </message>
    <message>
        <source>Let me open it…</source>
        <translation>允许我打开…</translation>
    </message>
    <message>
        <source>Name and always at start: {channel}…</source>
        <translation>固定名称并开机启用：{channel}…</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>停用</translation>
    </message>
</context>
<context>
    <name>FindingsPane</name>
    <message>
        <source>Check: the points were checked.</source>
        <translation>检查：各点已检查。</translation>
    </message>
    <message>
        <source>Check: nothing found.</source>
        <translation>检查：未发现问题。</translation>
    </message>
    <message>
        <source>The arm has moved since: its way to the first point is not checked.</source>
        <translation>此后机械臂已移动：从当前位置到首点的路径未经检查。</translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation>还有 {count} 条</translation>
    </message>
    <message>
        <source>Run now</source>
        <translation>立即运行</translation>
    </message>
    <message>
        <source>The cell “{name}” is not confirmed: its work area and what is held were counted, its tool was not. Confirm it, then check again.</source>
        <translation>单元“{name}”尚未确认：检查计入了其工作区和夹持的工件，未计入其工具。请确认单元后再检查一次。</translation>
    </message>
    <message>
        <source>The cell “{name}” could not be read: nothing of it was counted.</source>
        <translation>单元“{name}”无法读取：检查未计入其任何内容。</translation>
    </message>
    <message>
        <source>Row {row}: {text}</source>
        <translation>第 {row} 行：{text}</translation>
    </message>
    <message>
        <source>Sample {row}, at {seconds} s: {text}</source>
        <translation>第 {row} 个采样（{seconds} s）：{text}</translation>
    </message>
    <message>
        <source>Trim the recording there, or save it as points and change those.</source>
        <translation>请在该处裁剪录制，或存为轨迹点后修改这些点。</translation>
    </message>
    <message>
        <source>✕ Error</source>
        <translation>✕ 错误</translation>
    </message>
    <message>
        <source>! Warning</source>
        <translation>! 警告</translation>
    </message>
    <message>
        <source>Accept the warnings and run</source>
        <translation>接受警告并运行</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The check found errors: {errors}, warnings: {warnings}</source>
        <translation>检查：{errors} 个错误，{warnings} 个警告</translation>
    </message>
</context>
<context>
    <name>FolderBar</name>
    <message>
        <source>The folder “{name}” is gone: it was renamed, moved or deleted elsewhere. All trajectories are listed.</source>
        <translation>文件夹“{name}”已不在：它在别处被改名、移动或删除。现在显示全部轨迹。</translation>
    </message>
    <message>
        <source>Choose a trajectory in the list first</source>
        <translation>请先在列表中选择轨迹</translation>
    </message>
    <message>
        <source>Not saved yet. Open it and save it first</source>
        <translation>尚未保存。请先打开并保存</translation>
    </message>
    <message>
        <source>There is no folder yet. Make one first</source>
        <translation>还没有文件夹。请先新建一个</translation>
    </message>
    <message>
        <source>Moves what is chosen to a folder</source>
        <translation>把选中的轨迹移到某个文件夹</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>改名</translation>
    </message>
    <message>
        <source>Name of the folder</source>
        <translation>文件夹名称</translation>
    </message>
    <message>
        <source>All folders</source>
        <translation>全部文件夹</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>The folder whose trajectories are listed</source>
        <translation>列表显示该文件夹中的轨迹</translation>
    </message>
    <message>
        <source>New folder; rename or delete the one that is listed</source>
        <translation>新建文件夹；改名或删除当前显示的文件夹</translation>
    </message>
    <message>
        <source>Move to…</source>
        <translation>移到…</translation>
    </message>
    <message>
        <source>New folder…</source>
        <translation>新建文件夹…</translation>
    </message>
    <message>
        <source>Rename the folder…</source>
        <translation>改名文件夹…</translation>
    </message>
    <message>
        <source>Delete the folder</source>
        <translation>删除文件夹</translation>
    </message>
    <message>
        <source>Choose the folder in the list first</source>
        <translation>请先在列表中选择文件夹</translation>
    </message>
    <message>
        <source>Into no folder</source>
        <translation>不放入文件夹</translation>
    </message>
    <message>
        <source>The folder “{name}” cannot be read. Check the rights to it, and its disk or network share.</source>
        <translation>无法读取文件夹“{name}”。请检查其权限，以及所在的磁盘或网络共享。</translation>
    </message>
</context>
<context>
    <name>ForceTab</name>
    <message>
        <source>“{name}” is added, and nothing else has changed. Choose it under “Type it” to put it in force.</source>
        <translation>已添加“{name}”，其他都没有改变。在“手动输入”的列表中选择它后才生效。</translation>
    </message>
    <message>
        <source>Press Add. It is in force once it is chosen in the list.</source>
        <translation>请按“添加”。在列表中选择后才生效。</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
</context>
<context>
    <name>FrameByPoints</name>
    <message>
        <source>Takes the measured place of the tool; nothing moves.</source>
        <translation>采集末端的实测位置；不会运动。</translation>
    </message>
    <message>
        <source>{value} mm from the origin; at least {wanted} mm are needed.</source>
        <translation>距原点 {value} mm；至少需要 {wanted} mm。</translation>
    </message>
    <message>
        <source>{value} mm and {angle}° off the X axis; at least {wanted}° are needed.</source>
        <translation>偏离 X 轴 {value} mm、{angle}°；至少需要 {wanted}°。</translation>
    </message>
    <message>
        <source>Not all points are taken yet.</source>
        <translation>三点尚未采集完。</translation>
    </message>
    <message>
        <source>No frame is chosen.</source>
        <translation>未选择坐标系。</translation>
    </message>
    <message>
        <source>Adds the frame found under a new name; it is in force once it is chosen.</source>
        <translation>以新名称添加求得的坐标系；选择后才生效。</translation>
    </message>
    <message>
        <source>Puts the frame found in the place of “{name}”. Points of trajectories that belong to it move with it; their way is checked anew.</source>
        <translation>用所得坐标系替换“{name}”。轨迹中属于它的点随之移动，其路径将重新检查。</translation>
    </message>
    <message>
        <source>New frame</source>
        <translation>新坐标系</translation>
    </message>
    <message>
        <source>X {x}  Y {y}  Z {z} mm in the base</source>
        <translation>基坐标系 X {x}  Y {y}  Z {z} mm</translation>
    </message>
    <message>
        <source>Found, in the base: {frame}
Z points along {direction}</source>
        <translation>所得（基坐标系中）：{frame}
Z 轴指向 {direction}</translation>
    </message>
    <message>
        <source>“{name}” is in force: jog along it in Cartesian, by its button beside − and +.</source>
        <translation>“{name}”已生效：在“末端控制”中按“− / + 方向”旁它的按钮，即可沿它点动。</translation>
    </message>
    <message>
        <source>Bring the tool&apos;s tip to what becomes the origin (by Jog above, or lead the arm by hand), and press Origin.</source>
        <translation>把工具尖端移到将作为原点的位置（用上方的“点动”或用手拖动机械臂），再按“原点”。</translation>
    </message>
    <message>
        <source>Jog the tip along what becomes the X axis, as far as you can; press On +X.</source>
        <translation>沿将作为 X 轴的方向把工具尖移到尽量远处，按“+X 上”。</translation>
    </message>
    <message>
        <source>Jog the tip to the side where +Y is to be; press On the +Y side.</source>
        <translation>把工具尖移到 +Y 所在的一侧，按“+Y 一侧”。</translation>
    </message>
    <message>
        <source>Look at the axes in the picture: is Z as you want it? Then press Add. If not, take a point again.</source>
        <translation>请看画面中的坐标轴：Z 的朝向对吗？对则按“添加”；不对请重新采集某一点。</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>On +X</source>
        <translation>+X 上</translation>
    </message>
    <message>
        <source>On the +Y side</source>
        <translation>+Y 一侧</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Frame found</source>
        <translation>所得坐标系</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>重新开始</translation>
    </message>
</context>
<context>
    <name>FrameChoice</name>
    <message>
        <source>− and + along</source>
        <translation>− / + 方向</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>工具坐标系</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>用户坐标系</translation>
    </message>
</context>
<context>
    <name>FrameColumn</name>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>报文</translation>
    </message>
    <message>
        <source>Sender</source>
        <translation>发送方</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Rate, Hz</source>
        <translation>频率 Hz</translation>
    </message>
    <message>
        <source>Jitter, ms</source>
        <translation>抖动 ms</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>帧数</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>最近一帧</translation>
    </message>
    <message>
        <source>The identifier on the bus, offsets of 0x470 included</source>
        <translation>总线上的 ID，包含 0x470 设置的偏移</translation>
    </message>
    <message>
        <source>What the frame is; its signals are below it</source>
        <translation>该帧的含义；下方是其中的信号</translation>
    </message>
    <message>
        <source>Judged by the identifier: a frame that is neither this program&apos;s nor an arm&apos;s is another host&apos;s</source>
        <translation>按 ID 判断：既不是本程序发送、也不是机械臂会发送的帧，属于其他程序</translation>
    </message>
    <message>
        <source>Bytes that have changed within the last second are lit</source>
        <translation>最近 1 秒内变化过的字节会点亮</translation>
    </message>
    <message>
        <source>What the last frame said, in physical units</source>
        <translation>最近一帧的内容，按物理单位</translation>
    </message>
    <message>
        <source>Over the last 3 s, and at least 8 cycles</source>
        <translation>按最近 3 秒计算，至少 8 个周期</translation>
    </message>
    <message>
        <source>How far the cycles of the last 3 s are from their mean on average / the longest cycle since the counting began</source>
        <translation>最近 3 秒内周期与其平均值的平均偏差 / 开始统计以来最长的周期</translation>
    </message>
    <message>
        <source>Since the counting began</source>
        <translation>开始统计以来</translation>
    </message>
    <message>
        <source>When the last frame came</source>
        <translation>最近一帧到达的时间</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>内容</translation>
    </message>
</context>
<context>
    <name>FrameEffect</name>
    <message>
        <source>A question or a lamp: nothing moves. A press sends it.</source>
        <translation>查询或灯光：不会产生运动。按一下即发送。</translation>
    </message>
    <message>
        <source>The motion under way ends or pauses; the joints keep their power.</source>
        <translation>正在进行的运动会终止或暂停；关节保持上电。</translation>
    </message>
    <message>
        <source>An emergency stop: the motors only brake and the arm sinks. Hold it. The stop button above is faster, reaches every identifier and is repeated until the arm confirms.</source>
        <translation>急停：电机只起阻尼作用，机械臂会下沉。请扶住机械臂。上方的急停按钮更快，会发往每个 ID，并重复发送直到机械臂确认。</translation>
    </message>
    <message>
        <source>Motors lose their power and there are no brakes: the ARM DROPS. Hold the arm.</source>
        <translation>电机断电且没有抱闸：机械臂会坠落。请扶住机械臂。</translation>
    </message>
    <message>
        <source>The joints go limp until their next setpoint: the ARM FALLS unless setpoints follow at once. Support the arm. Only a reset leads back from there.</source>
        <translation>在下一个设定值到来之前关节失力：若没有设定值立即跟上，机械臂会坠落。请托住机械臂。之后只能通过复位恢复。</translation>
    </message>
    <message>
        <source>Drives one motor past the arm&apos;s own planning and limits. With gains of 0 its joint has no strength and falls. Support the arm, keep away from it.</source>
        <translation>绕过机械臂自身的规划和限位直接驱动一个电机。增益为 0 时该关节无力并坠落。请托住机械臂，并与其保持距离。</translation>
    </message>
    <message>
        <source>The arm may set out at once, without any check. Keep away from it.</source>
        <translation>机械臂可能立即运动，不经任何检查。请远离机械臂。</translation>
    </message>
    <message>
        <source>The gripper may close, open or lose its power and let go, without any check. Keep your fingers away.</source>
        <translation>夹爪可能闭合、张开，或断电松开，不经任何检查。请勿将手指放入。</translation>
    </message>
    <message>
        <source>The joints give way to a hand, and sink if the load is not set. Hold the arm.</source>
        <translation>关节可被手拖动；若未设置负载会下沉。请扶住机械臂。</translation>
    </message>
    <message>
        <source>Motors get their power: joints may jerk. Keep away from the arm.</source>
        <translation>电机上电：关节可能抖动。请远离机械臂。</translation>
    </message>
    <message>
        <source>Changes whether the arm leads or follows, or its identifiers. It is kept when the arm is switched off, and the arm may fall silent to this program.</source>
        <translation>改变机械臂的主从角色或其 ID。断电后仍保留，本程序可能再也收不到该机械臂。</translation>
    </message>
    <message>
        <source>Changes something the arm keeps, also when it is switched off: zeros, limits, levels or the load. Read it anew in its panel afterwards.</source>
        <translation>改变机械臂断电后仍保留的内容：零点、限位、等级或负载。之后请在相应面板中重新读取。</translation>
    </message>
    <message>
        <source>The arm is told to say nothing: nobody sees what it does until it is told to speak again or is switched off and on.</source>
        <translation>令机械臂静默：在解除静默或重新上电之前，无人能看到它在做什么。</translation>
    </message>
    <message>
        <source>No public text says what this frame does. Expect anything: support the arm, keep away from it.</source>
        <translation>没有公开资料说明该帧的作用，什么都可能发生：请托住机械臂，并与其保持距离。</translation>
    </message>
</context>
<context>
    <name>FrameKind</name>
    <message>
        <source>unknown identifier</source>
        <translation>未知 ID</translation>
    </message>
    <message>
        <source>wrong length</source>
        <translation>长度错误</translation>
    </message>
    <message>
        <source>value outside its table</source>
        <translation>数值不在表中</translation>
    </message>
    <message>
        <source>Error frame of the adapter</source>
        <translation>适配器的错误帧</translation>
    </message>
    <message>
        <source>Remote frame: a question without data</source>
        <translation>远程帧：不带数据的请求</translation>
    </message>
    <message>
        <source>CAN FD frame: the arm speaks classic CAN</source>
        <translation>CAN FD 帧：机械臂使用经典 CAN</translation>
    </message>
    <message>
        <source>29-bit identifier: the arm uses none</source>
        <translation>29 位 ID：机械臂不使用</translation>
    </message>
    <message>
        <source>Firmware upgrade: not documented</source>
        <translation>固件升级：无公开资料</translation>
    </message>
    <message>
        <source>Of an arm with other identifiers (0x470)</source>
        <translation>属于 ID 偏移不同的机械臂（0x470）</translation>
    </message>
    <message>
        <source>Unknown: not in the tables of this arm</source>
        <translation>未知：不在该机械臂的协议表中</translation>
    </message>
</context>
<context>
    <name>FrameName</name>
    <message>
        <source>Lamp of a joint</source>
        <translation>关节灯光</translation>
    </message>
    <message>
        <source>Stop, trajectory and teaching command</source>
        <translation>急停、轨迹与示教指令</translation>
    </message>
    <message>
        <source>Control mode, kind of motion, speed</source>
        <translation>控制模式、运动模式、速度</translation>
    </message>
    <message>
        <source>Target X, Y</source>
        <translation>目标 X、Y</translation>
    </message>
    <message>
        <source>Target Z, RX</source>
        <translation>目标 Z、RX</translation>
    </message>
    <message>
        <source>Target RY, RZ</source>
        <translation>目标 RY、RZ</translation>
    </message>
    <message>
        <source>Target angles J1, J2</source>
        <translation>目标角度 J1、J2</translation>
    </message>
    <message>
        <source>Target angles J3, J4</source>
        <translation>目标角度 J3、J4</translation>
    </message>
    <message>
        <source>Target angles J5, J6</source>
        <translation>目标角度 J5、J6</translation>
    </message>
    <message>
        <source>Point of the arc</source>
        <translation>圆弧点序号</translation>
    </message>
    <message>
        <source>Gripper command</source>
        <translation>夹爪指令</translation>
    </message>
    <message>
        <source>MIT setpoint of J{joint}</source>
        <translation>J{joint} MIT 设定值</translation>
    </message>
    <message>
        <source>Driver of J{joint}, fast values</source>
        <translation>J{joint} 驱动器高速反馈</translation>
    </message>
    <message>
        <source>Driver of J{joint}, slow values</source>
        <translation>J{joint} 驱动器低速反馈</translation>
    </message>
    <message>
        <source>Arm status</source>
        <translation>机械臂状态</translation>
    </message>
    <message>
        <source>End pose X, Y</source>
        <translation>末端位姿 X、Y</translation>
    </message>
    <message>
        <source>End pose Z, RX</source>
        <translation>末端位姿 Z、RX</translation>
    </message>
    <message>
        <source>End pose RY, RZ</source>
        <translation>末端位姿 RY、RZ</translation>
    </message>
    <message>
        <source>Angles of J1, J2</source>
        <translation>J1、J2 角度</translation>
    </message>
    <message>
        <source>Angles of J3, J4</source>
        <translation>J3、J4 角度</translation>
    </message>
    <message>
        <source>Angles of J5, J6</source>
        <translation>J5、J6 角度</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪反馈</translation>
    </message>
    <message>
        <source>Bus silence</source>
        <translation>总线静默</translation>
    </message>
    <message>
        <source>Linkage setting</source>
        <translation>联动设置</translation>
    </message>
    <message>
        <source>Motors on and off</source>
        <translation>电机使能与失能</translation>
    </message>
    <message>
        <source>Question: limits of a joint</source>
        <translation>查询：关节限制</translation>
    </message>
    <message>
        <source>Answer: angle and speed limits</source>
        <translation>应答：角度与速度限制</translation>
    </message>
    <message>
        <source>Setting: angle and speed limits</source>
        <translation>设置：角度与速度限制</translation>
    </message>
    <message>
        <source>Setting of a joint</source>
        <translation>关节设置</translation>
    </message>
    <message>
        <source>Answer to a setting</source>
        <translation>设置应答</translation>
    </message>
    <message>
        <source>Parameter question and command</source>
        <translation>参数查询与设置</translation>
    </message>
    <message>
        <source>Answer: limits of the end</source>
        <translation>应答：末端限制</translation>
    </message>
    <message>
        <source>Setting: limits of the end</source>
        <translation>设置：末端限制</translation>
    </message>
    <message>
        <source>Setting: collision levels</source>
        <translation>设置：碰撞防护等级</translation>
    </message>
    <message>
        <source>Answer: collision levels</source>
        <translation>应答：碰撞防护等级</translation>
    </message>
    <message>
        <source>Answer: acceleration limit</source>
        <translation>应答：加速度限制</translation>
    </message>
    <message>
        <source>Setting: teaching handle, gripper</source>
        <translation>设置：示教手柄与夹爪</translation>
    </message>
    <message>
        <source>Answer: teaching handle, gripper</source>
        <translation>应答：示教手柄与夹爪</translation>
    </message>
    <message>
        <source>End motion, part of J{joint}</source>
        <translation>末端运动，J{joint} 分量</translation>
    </message>
    <message>
        <source>Firmware version</source>
        <translation>固件版本</translation>
    </message>
    <message>
        <source>CPV of J{joint}</source>
        <translation>J{joint} 的 CPV 指令</translation>
    </message>
    <message>
        <source>CPV of the gripper</source>
        <translation>夹爪的 CPV 指令</translation>
    </message>
    <message>
        <source>Leader arm to zero</source>
        <translation>主臂回零</translation>
    </message>
    <message>
        <source>Solution of the pose J1, J2</source>
        <translation>位姿逆解 J1、J2</translation>
    </message>
    <message>
        <source>Solution of the pose J3, J4</source>
        <translation>位姿逆解 J3、J4</translation>
    </message>
    <message>
        <source>Solution of the pose J5, J6</source>
        <translation>位姿逆解 J5、J6</translation>
    </message>
    <message>
        <source>Setting: drag assistance</source>
        <translation>设置：拖动助力</translation>
    </message>
    <message>
        <source>Answer: drag assistance</source>
        <translation>应答：拖动助力</translation>
    </message>
</context>
<context>
    <name>FramesTab</name>
    <message>
        <source>Frame in force</source>
        <translation>当前坐标系</translation>
    </message>
    <message>
        <source>Frame by three points</source>
        <translation>三点法建立坐标系</translation>
    </message>
    <message>
        <source>Frame from the present tool pose</source>
        <translation>取当前末端位姿为坐标系</translation>
    </message>
    <message>
        <source>Apply the figures of the frame</source>
        <translation>应用坐标系的数值</translation>
    </message>
    <message>
        <source>Add as a new frame</source>
        <translation>添加为新坐标系</translation>
    </message>
    <message>
        <source>Delete the frame</source>
        <translation>删除坐标系</translation>
    </message>
    <message>
        <source>It is the room&apos;s: it moves with the figures under Base.</source>
        <translation>这是房间的坐标系：随“底座”中的数值移动。</translation>
    </message>
    <message>
        <source>Fills in the present tool pose, with the axes of the tool.</source>
        <translation>填入当前末端位姿，坐标轴即工具的坐标轴。</translation>
    </message>
    <message>
        <source>Press By three points, or type a name and the frame&apos;s pose in the base, then press Add.</source>
        <translation>请按“三点法”，或输入名称和坐标系在基坐标系中的位姿，再按“添加”。</translation>
    </message>
    <message>
        <source>— (base)</source>
        <translation>—（基坐标系）</translation>
    </message>
    <message>
        <source>Puts these figures in the place of those of the chosen frame. Points of trajectories that belong to it move with it; their way is checked anew.</source>
        <translation>用这些数值取代所选坐标系的数值。轨迹中属于它的点随之移动，其路径将重新检查。</translation>
    </message>
    <message>
        <source>Deletes the chosen frame; the base is chosen then. Trajectories with points that belong to it are not run until they have another frame.</source>
        <translation>删除所选坐标系，随后改用基坐标系。含有属于它的点的轨迹，在改换坐标系之前不能运行。</translation>
    </message>
    <message>
        <source>No frame is chosen. Add one, or choose one above.</source>
        <translation>未选择坐标系。请添加，或在上方选择。</translation>
    </message>
    <message>
        <source>Press Add for a further frame, or Apply: the chosen one gets these.</source>
        <translation>按“添加”新增一个坐标系，或按“应用”把这个名称和数值给所选坐标系。</translation>
    </message>
    <message>
        <source>Press Apply: the frame moves, and what belongs to it moves with it.</source>
        <translation>按“应用”：坐标系移动，属于它的点随之移动。</translation>
    </message>
    <message>
        <source>Poses are shown and typed in this frame. Choose another one, or the base.</source>
        <translation>位姿以该坐标系显示和输入。可改选其他坐标系或基坐标系。</translation>
    </message>
    <message>
        <source>Frame&apos;s name</source>
        <translation>坐标系名称</translation>
    </message>
    <message>
        <source>Adds a frame of this name; it is in force once it is chosen.</source>
        <translation>以此名称添加坐标系；选择后才生效。</translation>
    </message>
    <message>
        <source>Type it</source>
        <translation>手动输入</translation>
    </message>
    <message>
        <source>By three points</source>
        <translation>三点法</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>The frame&apos;s own pose, in the base (mm, °)</source>
        <translation>该坐标系在基坐标系中的位姿（mm、°）</translation>
    </message>
    <message>
        <source>From the present tool pose</source>
        <translation>取当前末端位姿</translation>
    </message>
</context>
<context>
    <name>GamepadAction</name>
    <message>
        <source>Dead man (hold to move)</source>
        <translation>使能键（按住才能动）</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Halt</source>
        <translation>停住</translation>
    </message>
    <message>
        <source>Next mode</source>
        <translation>切换模式</translation>
    </message>
    <message>
        <source>Begin or end an episode</source>
        <translation>开始或结束片段</translation>
    </message>
    <message>
        <source>Discard the last episode</source>
        <translation>弃用最后一个片段</translation>
    </message>
</context>
<context>
    <name>GamepadAxis</name>
    <message>
        <source>Left stick ↔</source>
        <translation>左摇杆 ↔</translation>
    </message>
    <message>
        <source>Left stick ↕</source>
        <translation>左摇杆 ↕</translation>
    </message>
    <message>
        <source>Right stick ↔</source>
        <translation>右摇杆 ↔</translation>
    </message>
    <message>
        <source>Right stick ↕</source>
        <translation>右摇杆 ↕</translation>
    </message>
    <message>
        <source>Right trigger</source>
        <translation>右扳机（速度）</translation>
    </message>
    <message>
        <source>D-pad ↕</source>
        <translation>方向键 ↕</translation>
    </message>
    <message>
        <source>D-pad ↔</source>
        <translation>方向键 ↔</translation>
    </message>
    <message>
        <source>Push away / pull</source>
        <translation>前推 / 后拉</translation>
    </message>
    <message>
        <source>Push left / right</source>
        <translation>左推 / 右推</translation>
    </message>
    <message>
        <source>Lift / press</source>
        <translation>上提 / 下压</translation>
    </message>
    <message>
        <source>Tilt left / right</source>
        <translation>左倾 / 右倾</translation>
    </message>
    <message>
        <source>Tilt away / towards</source>
        <translation>前倾 / 后倾</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
</context>
<context>
    <name>GamepadButton</name>
    <message>
        <source>Button {number}</source>
        <translation>按键 {number}</translation>
    </message>
</context>
<context>
    <name>GamepadDialog</name>
    <message>
        <source>Not installed: {packages}. In a terminal: {command}</source>
        <translation>未安装：{packages}。请在终端中运行：{command}</translation>
    </message>
    <message>
        <source>Found, but cannot be used (layout not known, or no permission): {names}</source>
        <translation>已发现但无法使用（布局未知或没有权限）：{names}</translation>
    </message>
    <message>
        <source>No device found. Plug one in, or switch it on and pair it.</source>
        <translation>未发现设备。请插入设备，或打开设备电源并配对。</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>手柄与 SpaceMouse</translation>
    </message>
    <message>
        <source>Jog by gamepad or SpaceMouse</source>
        <translation>用手柄或 SpaceMouse 点动</translation>
    </message>
    <message>
        <source>Only the axis that was pushed first moves, until all are at rest again</source>
        <translation>只有最先推动的轴会动，直到所有轴都回中</translation>
    </message>
    <message>
        <source>One axis at a time</source>
        <translation>一次只动一个轴</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>None found</source>
        <translation>未发现</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>摇杆与轴</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Nothing moves while this window is in front: try everything here. In the main window hold the dead-man button, then push an axis; letting go of either stops. The buttons for emergency stop and halt work at any time, in every window.</source>
        <translation>本窗口在前时机械臂不会动，可以放心试按。在主窗口中先按住使能键，再推动摇杆；松开任何一个即停止。急停和停住按键在任何窗口中随时有效。</translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation>复制命令</translation>
    </message>
</context>
<context>
    <name>GamepadMode</name>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>工具坐标系</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>用户坐标系</translation>
    </message>
</context>
<context>
    <name>GamepadStrip</name>
    <message>
        <source>{device} · {mode} · hold {button} and push an axis to jog</source>
        <translation>{device} · {mode} · 按住 {button} 并推动摇杆即可点动</translation>
    </message>
    <message>
        <source>{device} · {mode} · dead man held, ready</source>
        <translation>{device} · {mode} · 使能键已按住，可以推动摇杆</translation>
    </message>
    <message>
        <source>{device} · {mode} · jogging {axes}</source>
        <translation>{device} · {mode} · 正在点动 {axes}</translation>
    </message>
    <message>
        <source>{device} · {mode} · let every axis back to its centre</source>
        <translation>{device} · {mode} · 请先让所有摇杆回中</translation>
    </message>
    <message>
        <source>{device} · let go of {button}, then press it again</source>
        <translation>{device} · 请松开 {button} 后重新按下</translation>
    </message>
    <message>
        <source>Gamepad: {packages} not installed. Install with pip: armui[gamepad]</source>
        <translation>手柄：未安装 {packages}，请用 pip 安装 armui[gamepad]</translation>
    </message>
    <message>
        <source>Gamepad: {problem}</source>
        <translation>手柄：{problem}</translation>
    </message>
    <message>
        <source>Gamepad: none found. Plug one in or switch it on.</source>
        <translation>手柄：未发现设备，请插入或打开设备电源。</translation>
    </message>
</context>
<context>
    <name>GrantDialog</name>
    <message>
        <source>“{client}” asks for the arm</source>
        <translation>“{client}”申请操作机械臂</translation>
    </message>
    <message>
        <source>It then moves the arm by itself, within every check, until you take it back. Keep clear of the arm. Stop, halt, and any motion you begin end it.</source>
        <translation>授予后它会自行操作机械臂（仍受全部检查），直到您收回。请与机械臂保持距离。急停、停住或您自己的任何操作都会结束它。</translation>
    </message>
    <message>
        <source>It wants to set something, and moves nothing.</source>
        <translation>它只作设置，不会移动机械臂。</translation>
    </message>
    <message>
        <source>Purpose: {purpose}</source>
        <translation>用途：{purpose}</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>It asks for at most {percent} %. The speed at the top slows it at once.</source>
        <translation>它申请的最大速度为 {percent} %。顶部的速度可随时使它减速。</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>仅此一次</translation>
    </message>
    <message>
        <source>It asks again for the next time.</source>
        <translation>下次仍须申请。</translation>
    </message>
    <message>
        <source>For this connection</source>
        <translation>本次连接内</translation>
    </message>
    <message>
        <source>Until it disconnects, or you take the arm back, it need not ask again.</source>
        <translation>在它断开连接或您收回之前，无须再次申请。</translation>
    </message>
    <message>
        <source>Grant</source>
        <translation>授予</translation>
    </message>
</context>
<context>
    <name>Gripper</name>
    <message>
        <source>mm, calibrated</source>
        <translation>mm（已校准）</translation>
    </message>
</context>
<context>
    <name>GripperAct</name>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>失能</translation>
    </message>
    <message>
        <source>Clear error</source>
        <translation>清除错误</translation>
    </message>
    <message>
        <source>Set zero</source>
        <translation>零点设置</translation>
    </message>
</context>
<context>
    <name>GripperEditor</name>
    <message>
        <source>Nothing</source>
        <translation>无动作</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>张开</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Holds as before</source>
        <translation>夹持不变</translation>
    </message>
    <message>
        <source>Holds nothing</source>
        <translation>从此不夹工件</translation>
    </message>
    <message>
        <source>What the gripper holds from this point on</source>
        <translation>从该点起夹爪夹着的工件</translation>
    </message>
</context>
<context>
    <name>GripperFault</name>
    <message>
        <source>supply voltage too low</source>
        <translation>电源电压过低</translation>
    </message>
    <message>
        <source>motor too hot</source>
        <translation>电机过温</translation>
    </message>
    <message>
        <source>driver overcurrent</source>
        <translation>驱动器过流</translation>
    </message>
    <message>
        <source>driver too hot</source>
        <translation>驱动器过温</translation>
    </message>
    <message>
        <source>sensor abnormal</source>
        <translation>传感器异常</translation>
    </message>
    <message>
        <source>driver error</source>
        <translation>驱动器错误</translation>
    </message>
</context>
<context>
    <name>GripperLine</name>
    <message>
        <source>Closes the gripper to 0.</source>
        <translation>闭合夹爪，移动到 0。</translation>
    </message>
    <message>
        <source>Opens the gripper to its stroke limit.</source>
        <translation>张开夹爪，移动到行程限位。</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Measured: gripper</source>
        <translation>测量值：夹爪</translation>
    </message>
    <message>
        <source>Measured by the gripper</source>
        <translation>夹爪测得的值</translation>
    </message>
    <message>
        <source>Close fully</source>
        <translation>全闭</translation>
    </message>
    <message>
        <source>Open fully</source>
        <translation>全开</translation>
    </message>
    <message>
        <source>Insert with opening</source>
        <translation>带开度插入</translation>
    </message>
    <message>
        <source>An inserted point moves the gripper to the opening measured now, with 1 N·m (generation 1: 1 rad/s). To grip, enter less than the width of the workpiece.</source>
        <translation>插入的点会以 1 N·m（第 1 代：1 rad/s）把夹爪移动到当前测得的开度。要夹紧工件，请填比工件更小的开度。</translation>
    </message>
</context>
<context>
    <name>GripperPanel</name>
    <message>
        <source>Close the gripper</source>
        <translation>闭合夹爪</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>张开夹爪</translation>
    </message>
    <message>
        <source>Disable the gripper</source>
        <translation>失能夹爪</translation>
    </message>
    <message>
        <source>The gripper loses its power and drops what it holds. Hold the workpiece.</source>
        <translation>失能后夹爪会松开，所夹工件会掉落，请扶住工件。</translation>
    </message>
    <message>
        <source>Set the zero of the gripper</source>
        <translation>设置夹爪零点</translation>
    </message>
    <message>
        <source>Where the gripper stands now becomes its 0 mm, and it loses its power: it drops what it holds.
Close it by hand before. With a wrong zero it presses against its stop, or does not close.</source>
        <translation>夹爪的当前位置将成为 0 mm，同时夹爪断电，所夹工件会掉落。
请先用手将夹爪闭合。零点设错，夹爪会顶住机械限位或无法闭合。</translation>
    </message>
    <message>
        <source>No gripper heard</source>
        <translation>未收到夹爪反馈</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>已失能</translation>
    </message>
    <message>
        <source>Closes the gripper to 0.</source>
        <translation>闭合夹爪，移动到 0。</translation>
    </message>
    <message>
        <source>Opens the gripper to its stroke limit.</source>
        <translation>张开夹爪，移动到行程限位。</translation>
    </message>
    <message>
        <source>Moves the gripper to the target, and gives it power.</source>
        <translation>使能夹爪并运动到目标。</translation>
    </message>
    <message>
        <source>Gives the gripper power where it is.</source>
        <translation>使能夹爪，保持在当前位置。</translation>
    </message>
    <message>
        <source>Takes its power: it drops what it holds. Asks first.</source>
        <translation>切断夹爪动力，所夹工件会掉落。执行前会询问。</translation>
    </message>
    <message>
        <source>Clears its error; it has no power until enabled again.</source>
        <translation>清除夹爪错误；再次使能前夹爪无动力。</translation>
    </message>
    <message>
        <source>Makes the present opening its zero. Asks first.</source>
        <translation>将当前开度设为零点。执行前会询问。</translation>
    </message>
    <message>
        <source>How far this gripper turns is not published: watch where it ends.</source>
        <translation>该夹爪的最大角度未公布，请留意其行程终点。</translation>
    </message>
    <message>
        <source>The stroke limit has not been read: up to 100 mm can be set.</source>
        <translation>尚未读到行程限制，最大可设 100 mm。</translation>
    </message>
    <message>
        <source>Gripper control</source>
        <translation>夹爪控制</translation>
    </message>
    <message>
        <source>Close fully</source>
        <translation>全闭</translation>
    </message>
    <message>
        <source>Open fully</source>
        <translation>全开</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Calibrated: openings are as measured with callipers, by the cell&apos;s table.</source>
        <translation>已校准：开度按单元中的卡尺测量表。</translation>
    </message>
</context>
<context>
    <name>GripperRow</name>
    <message>
        <source>Closes the gripper by {step} at once. Hold to go on.</source>
        <translation>立即闭合 {step}，按住可连续动作。</translation>
    </message>
    <message>
        <source>Opens the gripper by {step} at once. Hold to go on.</source>
        <translation>立即张开 {step}，按住可连续动作。</translation>
    </message>
    <message>
        <source>Measured: {figure}</source>
        <translation>实测：{figure}</translation>
    </message>
    <message>
        <source>Measured by the gripper</source>
        <translation>夹爪反馈值</translation>
    </message>
    <message>
        <source>{figure} minus</source>
        <translation>{figure} 减</translation>
    </message>
    <message>
        <source>{figure} plus</source>
        <translation>{figure} 加</translation>
    </message>
</context>
<context>
    <name>GripperSettingsPanel</name>
    <message>
        <source>Gripper settings</source>
        <translation>夹爪设置</translation>
    </message>
    <message>
        <source>One of {choices}</source>
        <translation>可选 {choices}</translation>
    </message>
</context>
<context>
    <name>GripperTab</name>
    <message>
        <source>Every width is measured. Type another one, or apply the table.</source>
        <translation>所有开度均已测量。可再输入一个，或应用校准表。</translation>
    </message>
    <message>
        <source>Press Propose widths, or type openings to be measured.</source>
        <translation>按“推荐开度”，或输入要测量的开度。</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>已校准</translation>
    </message>
    <message>
        <source>Show and command calibrated openings</source>
        <translation>显示并发送已校准的开度</translation>
    </message>
    <message>
        <source>Apply the gripper table</source>
        <translation>应用夹爪校准表</translation>
    </message>
    <message>
        <source>Open to {width} mm</source>
        <translation>打开到 {width} mm</translation>
    </message>
    <message>
        <source>Calibrated: targets, points, the opening shown and the picture go by this table. Recordings keep what the arm told.</source>
        <translation>已校准：目标、轨迹点、显示的开度和画面都按此表。录制保留机械臂上报的值。</translation>
    </message>
    <message>
        <source>Row {row}: press Open, wait until the gripper stands, measure between the fingers with callipers and type what they show.</source>
        <translation>第 {row} 行：按“打开”，等夹爪停稳，用卡尺测量两指之间的距离并输入读数。</translation>
    </message>
    <message>
        <source>Propose widths for the gripper table</source>
        <translation>为夹爪校准表推荐开度</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Fills in widths over the gripper&apos;s stroke.</source>
        <translation>按夹爪行程填入开度。</translation>
    </message>
    <message>
        <source>Asked for</source>
        <translation>指令开度</translation>
    </message>
    <message>
        <source>Moves the gripper, uncalibrated.</source>
        <translation>移动夹爪，不经校准。</translation>
    </message>
    <message>
        <source>Off, everything is as the arm tells it; the table is kept.</source>
        <translation>关闭时一切按机械臂上报；校准表保留。</translation>
    </message>
    <message>
        <source>Puts the table in force; one of fewer than two pairs switches it off.</source>
        <translation>使校准表生效；不足两组时关闭校准。</translation>
    </message>
    <message>
        <source>Nothing is changed.</source>
        <translation>没有改动。</translation>
    </message>
    <message>
        <source>Two pairs at least are needed: type another width, and what is measured. Apply with fewer switches the calibration off.</source>
        <translation>至少需要两组：请再输入一个开度及其测量值。不足两组时按“应用”会关闭校准。</translation>
    </message>
    <message>
        <source>Press Apply: openings are calibrated from then on.</source>
        <translation>按“应用”：此后开度均已校准。</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Apply a table of two pairs at least first.</source>
        <translation>请先应用至少两组数据的校准表。</translation>
    </message>
    <message>
        <source>Open the gripper to the next width of its table</source>
        <translation>将夹爪打开到校准表的下一个开度</translation>
    </message>
    <message>
        <source>Propose widths</source>
        <translation>推荐开度</translation>
    </message>
</context>
<context>
    <name>GroupHeading</name>
    <message>
        <source>Folds this group away, or shows it.</source>
        <translation>折叠或展开此组。</translation>
    </message>
</context>
<context>
    <name>GuidePage</name>
    <message>
        <source>No section has “{text}”.</source>
        <translation>没有章节包含“{text}”。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>使用帮助</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>搜索帮助</translation>
    </message>
    <message>
        <source>Text of the help</source>
        <translation>帮助正文</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>en</source>
        <translation>zh</translation>
    </message>
</context>
<context>
    <name>HaltButton</name>
    <message>
        <source>Halt</source>
        <translation>停住</translation>
    </message>
    <message>
        <source>Ends any motion; the motors keep their power and the arm holds where it comes to rest. Key: {key}</source>
        <translation>结束一切运动；电机保持上电，机械臂停在哪里就保持在哪里。按键：{key}</translation>
    </message>
</context>
<context>
    <name>HeldTab</name>
    <message>
        <source>Held object</source>
        <translation>夹持的工件</translation>
    </message>
    <message>
        <source>Add an object to hold</source>
        <translation>添加工件</translation>
    </message>
    <message>
        <source>Apply the figures of the object</source>
        <translation>应用工件的数值</translation>
    </message>
    <message>
        <source>Delete the object</source>
        <translation>删除工件</translation>
    </message>
    <message>
        <source>What the held object may touch</source>
        <translation>工件可接触的物体</translation>
    </message>
    <message>
        <source>Tell the arm the object&apos;s load</source>
        <translation>把工件的负载告知机械臂</translation>
    </message>
    <message>
        <source>Put down</source>
        <translation>已放下</translation>
    </message>
    <message>
        <source>In the gripper: {mass} kg. The arm carries {most} kg at most.</source>
        <translation>夹持：{mass} kg。机械臂最多承载 {most} kg。</translation>
    </message>
    <message>
        <source>— (a new one)</source>
        <translation>—（新建）</translation>
    </message>
    <message>
        <source> (held)</source>
        <translation>（夹持中）</translation>
    </message>
    <message>
        <source>Adds an object of this name.</source>
        <translation>以此名称添加一个工件。</translation>
    </message>
    <message>
        <source>Choose an object above first.</source>
        <translation>请先在上方选择一个工件。</translation>
    </message>
    <message>
        <source>Puts these figures in the place of those of the chosen object.</source>
        <translation>用这些数值替换所选工件的数值。</translation>
    </message>
    <message>
        <source>Deletes the chosen object.</source>
        <translation>删除所选的工件。</translation>
    </message>
    <message>
        <source>It is held</source>
        <translation>已夹住</translation>
    </message>
    <message>
        <source>It counts in every check from now on. The gripper does not move.</source>
        <translation>从现在起计入每一次检查。夹爪不会动。</translation>
    </message>
    <message>
        <source>May touch: {count}</source>
        <translation>可接触：{count}</translation>
    </message>
    <message>
        <source>May touch…</source>
        <translation>可接触…</translation>
    </message>
    <message>
        <source>The work area has no plane or box yet.</source>
        <translation>工作区还没有平面或长方体。</translation>
    </message>
    <message>
        <source>What it may touch: the table, a tray.</source>
        <translation>工件可接触的物体，如桌面、托盘。</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>Press Apply first: the figures typed are not in force.</source>
        <translation>请先按“应用”：输入的数值尚未生效。</translation>
    </message>
    <message>
        <source>Tell: {load}</source>
        <translation>告知：{load}</translation>
    </message>
    <message>
        <source>“{name}” no longer counts in any check. The gripper does not move.</source>
        <translation>“{name}”不再计入任何检查。夹爪不会动。</translation>
    </message>
    <message>
        <source>Ø X, Y; length Z</source>
        <translation>直径 X、Y，长 Z</translation>
    </message>
    <message>
        <source>Tells the arm its end load; the program never does so by itself.</source>
        <translation>把末端负载告知机械臂。程序不会自动告知。</translation>
    </message>
    <message>
        <source>Press Apply to put the new figures in force.</source>
        <translation>按“应用”使新数值生效。</translation>
    </message>
    <message>
        <source>The gripper holds “{name}”: it counts in every check until Put down.</source>
        <translation>夹爪夹着“{name}”：按“已放下”之前它计入每一次检查。</translation>
    </message>
    <message>
        <source>Press Add. It counts as soon as it is marked as held.</source>
        <translation>按“添加”。标记为“已夹住”后才计入检查。</translation>
    </message>
    <message>
        <source>Press It is held once the gripper has closed on it.</source>
        <translation>夹爪夹紧它之后，按“已夹住”。</translation>
    </message>
    <message>
        <source>Type a name, the middle of the object in the flange, and its edges.</source>
        <translation>请输入名称、工件中心在法兰坐标系中的位置和边长。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Name of the held object</source>
        <translation>工件名称</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>圆头杆</translation>
    </message>
    <message>
        <source>Shape of the held object</source>
        <translation>工件形状</translation>
    </message>
</context>
<context>
    <name>HeldTarget</name>
    <message>
        <source>a target this program does not know</source>
        <translation>本程序不知道的位置</translation>
    </message>
</context>
<context>
    <name>HoldButton</name>
    <message>
        <source>Hold it for {seconds} s, with the mouse or the space bar.</source>
        <translation>请按住 {seconds} 秒（鼠标左键或空格键）。</translation>
    </message>
</context>
<context>
    <name>ImportReport</name>
    <message>
        <source>Import results</source>
        <translation>导入结果</translation>
    </message>
    <message>
        <source>{taken} imported, {left} not imported.</source>
        <translation>已导入 {taken} 个，未导入 {left} 个。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>✓ As “{name}”: the name “{requested}” was taken</source>
        <translation>✓ 已导入为“{name}”：名称“{requested}”已被占用</translation>
    </message>
    <message>
        <source>✓ As “{name}”</source>
        <translation>✓ 已导入为“{name}”</translation>
    </message>
</context>
<context>
    <name>InspectionDialog</name>
    <message>
        <source>There is no report yet.</source>
        <translation>还没有报告。</translation>
    </message>
    <message>
        <source>J{joint} swings. Keep clear of the arm.</source>
        <translation>J{joint} 正在摆动，请勿靠近机械臂。</translation>
    </message>
    <message>
        <source>slowly, at {speed}°/s</source>
        <translation>低速 {speed}°/s</translation>
    </message>
    <message>
        <source>over</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Joint inspection</source>
        <translation>关节巡检</translation>
    </message>
    <message>
        <source>Each joint in turn swings to either side and comes back, the others hold. How far it stays behind, the current it needs and its temperature are compared with the other joints and with earlier inspections of this arm. Choose a place with room around the arm, and the load it usually carries.</source>
        <translation>各关节依次左右摆动再回到原处，其余关节保持不动。落后量、所需电流和温度与其他关节比较，并与本机械臂以前的巡检比较。请选择周围有空间的位置，带上平常的负载。</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>摆幅</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>摆动范围</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>开始巡检</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
</context>
<context>
    <name>InspectionFinding</name>
    <message>
        <source>{joint} stays {value} behind its setpoint, the other joints {usual}.</source>
        <translation>{joint} 落后设定值 {value}，其他关节 {usual}。</translation>
    </message>
    <message>
        <source>{joint} stays {value} behind its setpoint, earlier {usual}.</source>
        <translation>{joint} 落后设定值 {value}，以前 {usual}。</translation>
    </message>
    <message>
        <source>{joint} needs {value} to turn, the joints of its kind {usual}.</source>
        <translation>{joint} 转动需要 {value}，同类关节 {usual}。</translation>
    </message>
    <message>
        <source>{joint} needs {value} to turn, earlier {usual}.</source>
        <translation>{joint} 转动需要 {value}，以前 {usual}。</translation>
    </message>
    <message>
        <source>The motor of {joint} is at {value}, the others at {usual}.</source>
        <translation>{joint} 的电机为 {value}，其他关节 {usual}。</translation>
    </message>
    <message>
        <source>The driver of {joint} is at {value}, the others at {usual}.</source>
        <translation>{joint} 的驱动器为 {value}，其他关节 {usual}。</translation>
    </message>
    <message>
        <source>See whether something holds the joint: a cable, a cover, the load. Compare its speed and acceleration under Joint settings. If it needs more current as well, it is stiff.</source>
        <translation>查看是否有东西牵住该关节：线缆、罩壳、负载。在“关节设置”中比较其速度和加速度。如果所需电流也增大，则为卡滞。</translation>
    </message>
    <message>
        <source>Hold the arm, switch the motor of this joint off and turn it by hand: does it grind or catch? Free cables and hoses, clean it. If it stays so, or grows from one inspection to the next, have its gear looked at.</source>
        <translation>扶住机械臂，关闭该关节电机，用手转动：是否有摩擦声或卡住？松开线缆和管路，清洁关节。如果仍然如此，或逐次巡检增大，请检修其减速器。</translation>
    </message>
    <message>
        <source>Let the arm cool and inspect it again. See what the joint carries where it mostly works, and whether it presses against something; give it pauses.</source>
        <translation>让机械臂冷却后再巡检一次。查看该关节在常用位置承受的负载，以及是否顶住了什么；适当停歇。</translation>
    </message>
</context>
<context>
    <name>InspectionReport</name>
    <message>
        <source>What stands out</source>
        <translation>异常之处</translation>
    </message>
    <message>
        <source>Nothing stands out.</source>
        <translation>无异常。</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>Swung less far</source>
        <translation>摆幅缩短</translation>
    </message>
    <message>
        <source>Joint inspection</source>
        <translation>关节巡检</translation>
    </message>
    <message>
        <source>Swings of ±{amplitude} at {speed}; compared with {count} earlier inspections</source>
        <translation>摆幅 ±{amplitude}，速度 {speed}；与以前 {count} 次巡检比较</translation>
    </message>
    <message>
        <source>It ended early. {reason}</source>
        <translation>提前结束。{reason}</translation>
    </message>
    <message>
        <source>Current to turn: arms of generation 1 tell no sign of their currents.</source>
        <translation>转动所需电流：第一代协议的电流没有符号。</translation>
    </message>
    <message>
        <source>Stays behind</source>
        <translation>落后</translation>
    </message>
    <message>
        <source>Current to turn it</source>
        <translation>转动所需电流</translation>
    </message>
    <message>
        <source>Current for what it bears</source>
        <translation>承重电流</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>电机</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Above: setpoint less angle, in degrees. Below: motor current, in A. Over time.</source>
        <translation>上：设定值减角度（°）。下：电机电流（A）。横轴为时间。</translation>
    </message>
    <message>
        <source>Each joint swings to and fro at the same angles. What turns round with it is friction and lag, and is compared; what stays is gravity, which each joint bears differently.</source>
        <translation>各关节在相同角度往返摆动。随方向反转的是摩擦和落后，予以比较；不变的是重力，各关节承受不同。</translation>
    </message>
</context>
<context>
    <name>InterfaceDialog</name>
    <message>
        <source>Serve the local interface</source>
        <translation>开启本地接口</translation>
    </message>
    <message>
        <source>Socket</source>
        <translation>套接字</translation>
    </message>
    <message>
        <source>Connected now</source>
        <translation>当前连接</translation>
    </message>
    <message>
        <source>Granted in this run</source>
        <translation>本次运行的授予记录</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copies the path.</source>
        <translation>复制路径。</translation>
    </message>
</context>
<context>
    <name>InterfaceMark</name>
    <message>
        <source>Interface: {count}</source>
        <translation>接口：{count}</translation>
    </message>
    <message>
        <source>The local interface is on; so many programs are connected.</source>
        <translation>本地接口已开启；数字为已连接的程序数。</translation>
    </message>
    <message>
        <source>Interface not served</source>
        <translation>接口未能开启</translation>
    </message>
</context>
<context>
    <name>InvalidFrame</name>
    <message>
        <source>{count} bytes instead of {wanted}</source>
        <translation>{count} 字节，应为 {wanted} 字节</translation>
    </message>
    <message>
        <source>it names a joint that no arm has</source>
        <translation>所指的关节不存在（1–6 之外）</translation>
    </message>
    <message>
        <source>outside its table: {signals}</source>
        <translation>超出取值表：{signals}</translation>
    </message>
</context>
<context>
    <name>JogBox</name>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>The speed in the top bar: it counts for every jog and step, also while one goes on.</source>
        <translation>顶栏的速度：对每次点动和步进有效，进行中也立即生效。</translation>
    </message>
    <message>
        <source>Step of − and +</source>
        <translation>− 和 + 的步长</translation>
    </message>
    <message>
        <source>How far one press of − or + moves</source>
        <translation>每按一次 − 或 + 移动多少</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>in the base</source>
        <translation>基坐标值</translation>
    </message>
    <message>
        <source>figures in “{name}”</source>
        <translation>数值：“{name}”坐标系</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具坐标系</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
</context>
<context>
    <name>JogCell</name>
    <message>
        <source>{name} minus</source>
        <translation>{name} 减</translation>
    </message>
    <message>
        <source>{name} plus</source>
        <translation>{name} 加</translation>
    </message>
    <message>
        <source>Measured {name}</source>
        <translation>测得的 {name}</translation>
    </message>
</context>
<context>
    <name>JogPanel</name>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Step of − and +</source>
        <translation>− 与 + 的步长</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>键盘</translation>
    </message>
    <message>
        <source>Keyboard jogging</source>
        <translation>键盘点动</translation>
    </message>
    <message>
        <source>Jog by keys, with the space bar held as dead-man key</source>
        <translation>用键盘点动，须按住空格键（使能键）</translation>
    </message>
</context>
<context>
    <name>JointItem</name>
    <message>
        <source>Status code:</source>
        <translation>状态码:</translation>
    </message>
    <message>
        <source>Supply voltage:</source>
        <translation>电源电压:</translation>
    </message>
    <message>
        <source>Motor temperature:</source>
        <translation>电机温度:</translation>
    </message>
    <message>
        <source>Driver current:</source>
        <translation>驱动器电流:</translation>
    </message>
    <message>
        <source>Driver temperature:</source>
        <translation>驱动器温度:</translation>
    </message>
    <message>
        <source>Sensor:</source>
        <translation>传感器状态:</translation>
    </message>
    <message>
        <source>Collision protection:</source>
        <translation>碰撞保护:</translation>
    </message>
    <message>
        <source>Driver error:</source>
        <translation>驱动器错误状态:</translation>
    </message>
    <message>
        <source>Driver enabled:</source>
        <translation>驱动器使能状态:</translation>
    </message>
    <message>
        <source>Homing:</source>
        <translation>回零状态:</translation>
    </message>
    <message>
        <source>Stall protection:</source>
        <translation>堵转保护:</translation>
    </message>
    <message>
        <source>Joint communication:</source>
        <translation>关节通讯:</translation>
    </message>
</context>
<context>
    <name>JointRow</name>
    <message>
        <source>Moves joint {joint} while it is held; let go to stop.</source>
        <translation>按住时关节 {joint} 运动，松开即停止。</translation>
    </message>
    <message>
        <source>Moves joint {joint} by −{step} at once. Hold to go on.</source>
        <translation>关节 {joint} 立即转动 −{step}。按住可连续运动。</translation>
    </message>
    <message>
        <source>Moves joint {joint} by +{step} at once. Hold to go on.</source>
        <translation>关节 {joint} 立即转动 +{step}。按住可连续运动。</translation>
    </message>
    <message>
        <source>Joint {joint} minus</source>
        <translation>关节 {joint} 减</translation>
    </message>
    <message>
        <source>Joint {joint} plus</source>
        <translation>关节 {joint} 加</translation>
    </message>
    <message>
        <source>Target angle of joint {joint}</source>
        <translation>关节 {joint} 目标角度</translation>
    </message>
    <message>
        <source>Target slider of joint {joint}</source>
        <translation>关节 {joint} 目标滑块</translation>
    </message>
    <message>
        <source>Measured angle of joint {joint}</source>
        <translation>关节 {joint} 测量角度</translation>
    </message>
    <message>
        <source>Measured by the arm</source>
        <translation>机械臂的测量值</translation>
    </message>
    <message>
        <source>Target of joint {joint}: {minimum} to {maximum}. Not sent before you press Send.</source>
        <translation>关节 {joint} 的目标：{minimum} 至 {maximum}。按“发送”后才会发出。</translation>
    </message>
    <message>
        <source>Limits read from the arm.</source>
        <translation>限位读自机械臂。</translation>
    </message>
    <message>
        <source>Factory limits: not read from the arm yet.</source>
        <translation>出厂限位：尚未从机械臂读取。</translation>
    </message>
</context>
<context>
    <name>JointSettingsPanel</name>
    <message>
        <source>Joint settings</source>
        <translation>关节设置</translation>
    </message>
    <message>
        <source>Factory limits for all joints</source>
        <translation>全部关节恢复出厂值</translation>
    </message>
    <message>
        <source>The angle limits, speeds and accelerations of all six joints become what they were when the arm left the factory. Limits set for this place, narrower ones too, are lost: save a backup first if you may need them again.</source>
        <translation>6 个关节的角度限位、速度和加速度都将恢复为出厂值。为现场设置的限位（包括更窄的限位）会丢失：如以后还需要，请先保存参数备份。</translation>
    </message>
    <message>
        <source>J{joint} stands at {value}, beyond the limits entered: it can only be moved back between them then.</source>
        <translation>J{joint} 当前为 {value}，超出所输入的限位：保存后只能向限位以内移动。</translation>
    </message>
    <message>
        <source>This arm&apos;s protocol (generation 1) has no command for it. Enter the values, or restore a backup.</source>
        <translation>该机械臂的协议（第 1 代）没有此指令。请手动输入数值，或从备份恢复。</translation>
    </message>
</context>
<context>
    <name>JointStatusButton</name>
    <message>
        <source>Joint status</source>
        <translation>关节状态</translation>
    </message>
    <message>
        <source>The worst of the six joints. Press to see all of them.</source>
        <translation>六个关节中最差的状态。点击查看全部关节。</translation>
    </message>
</context>
<context>
    <name>JointStatusModel</name>
    <message>
        <source>since {time}</source>
        <translation>自 {time} 起</translation>
    </message>
    <message>
        <source>not heard of late</source>
        <translation>最近没有收到</translation>
    </message>
</context>
<context>
    <name>JointStatusPage</name>
    <message>
        <source>Joint status</source>
        <translation>关节状态</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节序号</translation>
    </message>
    <message>
        <source>Clear error</source>
        <translation>清除错误</translation>
    </message>
    <message>
        <source>Ask the driver of joint {joint} to clear its error</source>
        <translation>让关节 {joint} 的驱动器清除错误</translation>
    </message>
    <message>
        <source>A time beside a fault says since when. Choose a cell to read it in full.</source>
        <translation>故障旁的时间表示故障从何时开始。选中单元格可查看详情。</translation>
    </message>
</context>
<context>
    <name>JointTable</name>
    <message>
        <source>Joint status in the log</source>
        <translation>日志中的关节状态</translation>
    </message>
</context>
<context>
    <name>JointVerdict</name>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>失能</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>有故障</translation>
    </message>
    <message>
        <source>Offline</source>
        <translation>离线</translation>
    </message>
</context>
<context>
    <name>JointWord</name>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Too low</source>
        <translation>过低</translation>
    </message>
    <message>
        <source>Too hot</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>Abnormal</source>
        <translation>异常</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>触发保护</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>失能</translation>
    </message>
    <message>
        <source>Not homed</source>
        <translation>没有回零</translation>
    </message>
    <message>
        <source>Homed</source>
        <translation>已经回零</translation>
    </message>
</context>
<context>
    <name>KeepDialog</name>
    <message>
        <source>Keep at every start</source>
        <translation>每次启动时保留</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>不再保留</translation>
    </message>
    <message>
        <source>Name of the adapter</source>
        <translation>适配器名称</translation>
    </message>
    <message>
        <source>Files of the system</source>
        <translation>系统文件</translation>
    </message>
    <message>
        <source>Write these files</source>
        <translation>写入这些文件</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>The system asks for the administrator&apos;s password. The name holds for this adapter by its serial number, wherever it is plugged in.</source>
        <translation>系统会询问管理员密码。名称按序列号固定在此适配器上，插在任何接口都有效。</translation>
    </message>
    <message>
        <source>The system asks for the administrator&apos;s password.</source>
        <translation>系统会询问管理员密码。</translation>
    </message>
    <message>
        <source>Taken away: {path}</source>
        <translation>移除：{path}</translation>
    </message>
    <message>
        <source>The files are being read.</source>
        <translation>正在读取文件内容。</translation>
    </message>
</context>
<context>
    <name>KeyPad</name>
    <message>
        <source>Keyboard jogging</source>
        <translation>键盘点动</translation>
    </message>
    <message>
        <source>Hold the space bar: a letter key is one step; held, it goes on.</source>
        <translation>按住空格键：按一次字母键走一步，按住则连续步进。</translation>
    </message>
    <message>
        <source>Hold the space bar and a letter key; release either to stop.</source>
        <translation>按住空格键，再按住下列字母键即运动；松开任一键即停止。</translation>
    </message>
    <message>
        <source>Click here to jog by keys.</source>
        <translation>点击此处后可用键盘点动。</translation>
    </message>
    <message>
        <source>Jogging is not possible now.</source>
        <translation>现在不能点动。</translation>
    </message>
</context>
<context>
    <name>LanguageButton</name>
    <message>
        <source>The other language; its font follows at the next start.</source>
        <translation>切换语言；字体在下次启动时更换。</translation>
    </message>
</context>
<context>
    <name>LeaseBar</name>
    <message>
        <source>Take the arm back from a program</source>
        <translation>从程序收回机械臂</translation>
    </message>
    <message>
        <source>Local interface: no program is connected</source>
        <translation>本地接口：没有程序连接</translation>
    </message>
    <message>
        <source>Local interface: {names} connected, without the arm</source>
        <translation>本地接口：{names} 已连接，未操作机械臂</translation>
    </message>
    <message>
        <source>“{client}” has the arm</source>
        <translation>“{client}”正在操作机械臂</translation>
    </message>
    <message>
        <source>at most {percent}</source>
        <translation>最高 {percent}</translation>
    </message>
    <message>
        <source>does nothing now</source>
        <translation>当前无动作</translation>
    </message>
    <message>
        <source>streams targets</source>
        <translation>连续发送目标</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>收回</translation>
    </message>
    <message>
        <source>Ends what the program does: the arm comes to rest with power on.</source>
        <translation>结束程序的操作：机械臂停下并保持使能。</translation>
    </message>
</context>
<context>
    <name>LeaveQuestion</name>
    <message>
        <source>What you changed in “{name}” has not been saved.</source>
        <translation>“{name}”中的修改尚未保存。</translation>
    </message>
</context>
<context>
    <name>Leaving</name>
    <message>
        <source>The stop is not confirmed</source>
        <translation>急停尚未确认</translation>
    </message>
    <message>
        <source>The arm has not said that it has stopped. The emergency stop is repeated only as long as the program is connected. Watch the arm.</source>
        <translation>机械臂尚未确认已停止。只有保持连接，程序才会重复发送急停。请注意机械臂。</translation>
    </message>
    <message>
        <source>Leave anyway</source>
        <translation>仍要离开</translation>
    </message>
    <message>
        <source>End it and go on</source>
        <translation>结束运行并继续操作</translation>
    </message>
    <message>
        <source>A run is under way</source>
        <translation>正在运行</translation>
    </message>
    <message>
        <source>A trajectory or recording is being run, or is paused. If you go on, the arm is told to end its motion where it is; its motors stay enabled. The rest of the run is not done.</source>
        <translation>轨迹或录制正在运行或已暂停。继续的话，机械臂将就地结束运动，电机保持使能，其余部分不再执行。</translation>
    </message>
    <message>
        <source>A motion is held back</source>
        <translation>有运动被保留</translation>
    </message>
    <message>
        <source>The arm holds back a motion. If you go on, the arm is told to drop it and stays where it is; its motors stay enabled.</source>
        <translation>机械臂保留着一个未完成的运动。继续操作时，将命令机械臂放弃该运动并停在原处；电机保持使能。</translation>
    </message>
</context>
<context>
    <name>Level</name>
    <message>
        <source>Information</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
</context>
<context>
    <name>LevelsPanel</name>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>All joints: level</source>
        <translation>全部关节：等级</translation>
    </message>
</context>
<context>
    <name>LibraryActions</name>
    <message>
        <source>Deleted: {names}</source>
        <translation>已删除：{names}</translation>
    </message>
    <message>
        <source>“{new}” is called “{old}” again.</source>
        <translation>“{new}”已改回原名“{old}”。</translation>
    </message>
    <message>
        <source>Moved back: {names}</source>
        <translation>已移回：{names}</translation>
    </message>
    <message>
        <source>In no folder now: {names}</source>
        <translation>已移出文件夹：{names}</translation>
    </message>
    <message>
        <source>Moved to the folder “{folder}”: {names}</source>
        <translation>已移到文件夹“{folder}”：{names}</translation>
    </message>
    <message>
        <source>Restored: {names}</source>
        <translation>已恢复：{names}</translation>
    </message>
    <message>
        <source>Undo deleting “{names}”</source>
        <translation>撤销删除“{names}”</translation>
    </message>
    <message>
        <source>Restores it.</source>
        <translation>将其恢复。</translation>
    </message>
    <message>
        <source>Undo renaming to “{names}”</source>
        <translation>撤销改名为“{names}”</translation>
    </message>
    <message>
        <source>It is called “{names}” again.</source>
        <translation>名称改回“{names}”。</translation>
    </message>
    <message>
        <source>Undo moving “{names}”</source>
        <translation>撤销移动“{names}”</translation>
    </message>
    <message>
        <source>It goes back to the folder it came from.</source>
        <translation>移回原来的文件夹。</translation>
    </message>
    <message>
        <source>Undo creating “{names}”</source>
        <translation>撤销创建“{names}”</translation>
    </message>
    <message>
        <source>Undo copying to “{names}”</source>
        <translation>撤销复制为“{names}”</translation>
    </message>
    <message>
        <source>Undo importing “{names}”</source>
        <translation>撤销导入“{names}”</translation>
    </message>
    <message>
        <source>Deletes it; it can be restored for 30 days.</source>
        <translation>将其删除；30 天内可恢复。</translation>
    </message>
</context>
<context>
    <name>LibraryBar</name>
    <message>
        <source>Import files</source>
        <translation>导入文件</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Record motion</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>改名</translation>
    </message>
    <message>
        <source>Export files</source>
        <translation>导出文件</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>text to read and edit, as the library keeps it</source>
        <translation>可阅读和编辑的文本，轨迹库即以此保存</translation>
    </message>
    <message>
        <source>for spreadsheets</source>
        <translation>用于电子表格</translation>
    </message>
    <message>
        <source>for scripts and other programs</source>
        <translation>用于脚本和其他程序</translation>
    </message>
    <message>
        <source>for another armui: a double click opens it</source>
        <translation>给另一台 armui：双击即打开</translation>
    </message>
    <message>
        <source>Search in names and notes</source>
        <translation>在名称和备注中搜索</translation>
    </message>
    <message>
        <source>Not saved yet. Open it and save it first</source>
        <translation>尚未保存，请先打开并保存</translation>
    </message>
    <message>
        <source>Choose one trajectory alone</source>
        <translation>请只选择一条轨迹</translation>
    </message>
    <message>
        <source>Choose a trajectory in the list first</source>
        <translation>请先在列表中选择轨迹</translation>
    </message>
</context>
<context>
    <name>LibraryButton</name>
    <message>
        <source>Trajectory library</source>
        <translation>轨迹库</translation>
    </message>
    <message>
        <source>Recording…</source>
        <translation>录制中…</translation>
    </message>
    <message>
        <source>Make, check, run and record trajectories</source>
        <translation>编辑、检查、运行和录制轨迹</translation>
    </message>
</context>
<context>
    <name>LibraryColumn</name>
    <message>
        <source>At a speed of 100 % at the top: at the points&apos; own or as recorded, without the way to the first point. How long a run takes at its speed stands beside Run.</source>
        <translation>顶栏速度为 100 % 时：按各点自身或录制的速度，不含到第一个点的路程。按当前速度运行所需的时间在“发送”旁。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Duration
at 100 %</source>
        <translation>时长
（100 %）</translation>
    </message>
    <message>
        <source>Last change</source>
        <translation>修改时间</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
</context>
<context>
    <name>LibraryExchange</name>
    <message>
        <source>Results…</source>
        <translation>导入结果…</translation>
    </message>
    <message>
        <source>Reading {names}…</source>
        <translation>正在读取 {names}…</translation>
    </message>
    <message>
        <source>The arm cannot run “{name}”. {reason}</source>
        <translation>机械臂无法运行“{name}”。{reason}</translation>
    </message>
    <message>
        <source>And {count} more. Open it and press Check to see them.</source>
        <translation>另有 {count} 条。打开它并按“检查”查看。</translation>
    </message>
    <message>
        <source>Imported: {names}</source>
        <translation>已导入：{names}</translation>
    </message>
    <message>
        <source>Their names were taken, so they got others: {names}</source>
        <translation>名称已被占用，已改名：{names}</translation>
    </message>
    <message>
        <source>And {count} more. See the results.</source>
        <translation>另有 {count} 条，请看结果。</translation>
    </message>
    <message>
        <source>Not imported. {reason}</source>
        <translation>未导入。{reason}</translation>
    </message>
    <message>
        <source>Not imported yet. {reason}</source>
        <translation>尚未导入。{reason}</translation>
    </message>
    <message>
        <source>Not imported either: {count} more. See the results.</source>
        <translation>另有 {count} 个文件未导入，详见导入结果。</translation>
    </message>
    <message>
        <source>Not imported yet: {names}. Press “Import by columns…”.</source>
        <translation>尚未导入：{names}。请按“按列导入…”。</translation>
    </message>
    <message>
        <source>the tool “{name}”</source>
        <translation>工具“{name}”</translation>
    </message>
    <message>
        <source>Poses in it are those of {tool}, as the editor shows them.</source>
        <translation>其中的位姿是{tool}的位姿，与编辑器中显示的一致。</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Not exported. {reason}</source>
        <translation>未导出：{reason}</translation>
    </message>
    <message>
        <source>Not exported either: {count} more.</source>
        <translation>另有 {count} 条轨迹未导出。</translation>
    </message>
    <message>
        <source>Exported: {names}</source>
        <translation>已导出：{names}</translation>
    </message>
</context>
<context>
    <name>LibraryFiles</name>
    <message>
        <source>Trajectories</source>
        <translation>轨迹文件</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>所有文件</translation>
    </message>
    <message>
        <source>Import files</source>
        <translation>导入文件</translation>
    </message>
    <message>
        <source>Export file</source>
        <translation>导出文件</translation>
    </message>
    <message>
        <source>Export files into a folder</source>
        <translation>导出文件到文件夹</translation>
    </message>
</context>
<context>
    <name>LibraryHint</name>
    <message>
        <source>Show all</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Nothing found for “{text}”</source>
        <translation>未找到“{text}”</translation>
    </message>
    <message>
        <source>Neither a name nor a note holds this text.</source>
        <translation>名称和备注中都没有这段文字。</translation>
    </message>
    <message>
        <source>Nothing in this folder yet</source>
        <translation>此文件夹还是空的</translation>
    </message>
    <message>
        <source>What is created, recorded or imported now comes into it; “Move to…” brings others here.</source>
        <translation>现在创建、录制或导入的轨迹会放在这里；用“移到…”可把其他轨迹移来。</translation>
    </message>
    <message>
        <source>No trajectories yet</source>
        <translation>还没有轨迹</translation>
    </message>
    <message>
        <source>Create one and enter its points, record a motion of the arm, or import files. Files can also be dropped here.</source>
        <translation>可以创建轨迹并输入点位，录制机械臂的运动，或导入文件，也可以把文件拖放到这里。</translation>
    </message>
</context>
<context>
    <name>LibraryModel</name>
    <message>
        <source>{count} samples</source>
        <translation>{count} 个采样</translation>
    </message>
    <message>
        <source>Folder: {name}</source>
        <translation>文件夹：{name}</translation>
    </message>
    <message>
        <source>Unsaved changes of a trajectory that was never saved, or whose file is gone. Open it to save it, or delete it.</source>
        <translation>该轨迹从未保存过，或其文件已不存在，这里是未保存的更改。请打开后保存，或将其删除。</translation>
    </message>
    <message>
        <source>✓ checked</source>
        <translation>✓ 通过</translation>
    </message>
    <message>
        <source>! warnings</source>
        <translation>! 有警告</translation>
    </message>
    <message>
        <source>✕ errors</source>
        <translation>✕ 有错误</translation>
    </message>
    <message>
        <source>✕ damaged</source>
        <translation>✕ 已损坏</translation>
    </message>
    <message>
        <source>! not saved</source>
        <translation>! 未保存</translation>
    </message>
    <message>
        <source>This was taught on another arm: {taught}. Chosen is {arm}.</source>
        <translation>此轨迹在另一种机械臂上示教：{taught}。当前选择的是 {arm}。</translation>
    </message>
    <message>
        <source>Click: checks it, and lists below what is found.</source>
        <translation>点击：检查此轨迹，并在下方列出发现的问题。</translation>
    </message>
    <message>
        <source>none saved</source>
        <translation>均未保存</translation>
    </message>
    <message>
        <source>! other arm</source>
        <translation>! 其他机械臂</translation>
    </message>
    <message>
        <source>It is being worked out.</source>
        <translation>正在计算。</translation>
    </message>
</context>
<context>
    <name>LibraryPage</name>
    <message>
        <source>“{name}” is not saved yet. Open it and save it first.</source>
        <translation>“{name}”尚未保存，请先打开并保存。</translation>
    </message>
    <message>
        <source>“{name}” ended at row {row}. {reason}</source>
        <translation>“{name}”在第 {row} 行结束。{reason}</translation>
    </message>
    <message>
        <source>“{name}” is open. Close its window first.</source>
        <translation>“{name}”正打开着，请先关闭其窗口。</translation>
    </message>
    <message>
        <source>Trajectory library</source>
        <translation>轨迹库</translation>
    </message>
    <message>
        <source>Saved as “{name}”.</source>
        <translation>已保存为“{name}”。</translation>
    </message>
    <message>
        <source>Deleted: {names}</source>
        <translation>已删除：{names}</translation>
    </message>
    <message>
        <source>“{name}” is running. End its run first.</source>
        <translation>“{name}”正在执行，请先结束执行。</translation>
    </message>
    <message>
        <source>“{name}” ended after {done} of the recording. {reason}</source>
        <translation>“{name}”在录制的 {done} 处结束。{reason}</translation>
    </message>
    <message>
        <source>Name of the trajectory</source>
        <translation>轨迹名称</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>轨迹</translation>
    </message>
</context>
<context>
    <name>LightEditor</name>
    <message>
        <source>Nothing</source>
        <translation>无动作</translation>
    </message>
    <message>
        <source>Lamp: 0 to 254, or all</source>
        <translation>灯编号：0 至 254，或 all（全部）</translation>
    </message>
    <message>
        <source>Grey values of red, green and blue, 0 to 255: 255,128,0</source>
        <translation>红、绿、蓝灰度值，0 至 255，例如 255,128,0</translation>
    </message>
</context>
<context>
    <name>LightPanel</name>
    <message>
        <source>Every lamp is chosen. Take the tick away to choose one.</source>
        <translation>已选择全部灯珠。取消勾选后可选择单个灯珠。</translation>
    </message>
    <message>
        <source>Sends the colour to the lamps; nothing moves.</source>
        <translation>把颜色发送到灯珠，机械臂不会运动。</translation>
    </message>
    <message>
        <source>Light control</source>
        <translation>灯光控制</translation>
    </message>
    <message>
        <source>Lamps of joint {joint}</source>
        <translation>关节 {joint} 的灯珠</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>The colour that Send colour sends</source>
        <translation>点击“确认”后发送的颜色</translation>
    </message>
    <message>
        <source>Opens a window to pick a colour in; nothing is sent.</source>
        <translation>打开选取颜色的窗口，不发送任何指令。</translation>
    </message>
    <message>
        <source>Pick a colour…</source>
        <translation>选取颜色…</translation>
    </message>
    <message>
        <source>All lamps of the joint</source>
        <translation>该关节的全部灯珠</translation>
    </message>
    <message>
        <source>Colour of the lamps</source>
        <translation>灯光颜色</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效果</translation>
    </message>
    <message>
        <source>Works on joints that have a lamp board.
Lamps give no feedback: this is only what will be sent.</source>
        <translation>若已安装关节灯板，即可控制其灯光。
灯光没有反馈：此处仅显示要发送的颜色。</translation>
    </message>
    <message>
        <source>Send colour</source>
        <translation>确认</translation>
    </message>
</context>
<context>
    <name>LinkagePanel</name>
    <message>
        <source>The arm becomes, or stays, a motion output arm. The program listens and talks on the identifiers that the offsets lead to.</source>
        <translation>机械臂将成为（或保持为）运动输出臂。程序将按偏移后的 ID 收发报文。</translation>
    </message>
    <message>
        <source>Every arm on this bus obeys this setting: leave only the one meant connected. The arm keeps it when switched off. It takes effect in standby, or after a power cycle.</source>
        <translation>总线上的所有机械臂都会响应此设置，请只连接要设置的机械臂。该设置断电后仍保留，在待机模式下或重新上电后生效。</translation>
    </message>
    <message>
        <source>Set the linkage</source>
        <translation>设置联动</translation>
    </message>
    <message>
        <source>Set linkage…</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>The arm becomes a teaching input and goes deaf: it obeys no command, not even the emergency stop; only cutting its power stops it. Its feedback ends, it can be led by hand and sends its own commands to the following arm.</source>
        <translation>机械臂成为示教输入臂后不再听任何指令，急停也无效，只有切断电源才能使它停止。它不再反馈，可用手拖动，并向跟随的机械臂发送自己的指令。</translation>
    </message>
    <message>
        <source>Set linkage</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Stored: teaching input. The arm still obeys; it goes deaf at the next standby, also when an emergency stop is released, or after a power cycle. To undo it:</source>
        <translation>已存储：示教输入臂。目前仍响应指令；下次进入待机（解除急停也会进入）或重新上电后，不再听任何指令。如需撤销：</translation>
    </message>
    <message>
        <source>In use: —</source>
        <translation>当前使用：—</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>In use: feedback {feedback}, commands {control}</source>
        <translation>当前使用：反馈 {feedback}，控制 {control}</translation>
    </message>
    <message>
        <source>Linkage control</source>
        <translation>联动控制</translation>
    </message>
    <message>
        <source>Linkage setting</source>
        <translation>联动设置指令</translation>
    </message>
    <message>
        <source>Leader arm (teaching input)</source>
        <translation>主臂（示教输入臂）</translation>
    </message>
    <message>
        <source>Follower arm (motion output)</source>
        <translation>从臂（运动输出臂）</translation>
    </message>
    <message>
        <source>Feedback offset</source>
        <translation>反馈指令偏移值</translation>
    </message>
    <message>
        <source>Control offset</source>
        <translation>控制指令偏移值</translation>
    </message>
    <message>
        <source>Address offset</source>
        <translation>地址偏移值</translation>
    </message>
    <message>
        <source>Where a teaching input sends its commands: the control offset of its follower</source>
        <translation>示教输入臂发送指令的目标地址，即从臂的控制指令偏移值</translation>
    </message>
    <message>
        <source>The arm on this bus is a teaching input: it sends commands for a following arm and no feedback. It obeys nothing but this:</source>
        <translation>总线上的机械臂是示教输入臂：只向从臂发送指令，不上报反馈，仅响应以下操作：</translation>
    </message>
    <message>
        <source>Back to a motion output arm without offsets</source>
        <translation>恢复为运动输出臂（不偏移）</translation>
    </message>
    <message>
        <source>Says what will change, and asks first.</source>
        <translation>先说明会改变什么，并询问。</translation>
    </message>
    <message>
        <source>The arm cannot be asked for this setting: armui uses the IDs it hears.</source>
        <translation>此设置无法从机械臂查询：本程序以实际收到的 ID 为准。</translation>
    </message>
</context>
<context>
    <name>List</name>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
</context>
<context>
    <name>LiveMark</name>
    <message>
        <source>Live stream not served</source>
        <translation>实时数据流未提供</translation>
    </message>
    <message>
        <source>Live, open to the network: {address}</source>
        <translation>实时数据流，对网络开放：{address}</translation>
    </message>
    <message>
        <source>Live: {address}</source>
        <translation>实时数据流：{address}</translation>
    </message>
    <message>
        <source>A program watches.</source>
        <translation>有程序正在观看。</translation>
    </message>
    <message>
        <source>Nobody watches.</source>
        <translation>无人观看。</translation>
    </message>
    <message>
        <source>Frames dropped, as they were not sent in time: {lost}. How often a program was seen not to keep up, and missed messages: {behind}.</source>
        <translation>因来不及发送而丢弃的帧：{lost}。发现观看程序跟不上、错过消息的次数：{behind}。</translation>
    </message>
</context>
<context>
    <name>LiveStrip</name>
    <message>
        <source>The arm that is connected now:</source>
        <translation>当前连接的机械臂：</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>armui – PiPER arm</source>
        <translation>armui – PiPER 机械臂</translation>
    </message>
    <message>
        <source>3D view of the arm</source>
        <translation>机械臂 3D 视图</translation>
    </message>
    <message>
        <source>The arm is moving</source>
        <translation>机械臂正在运动</translation>
    </message>
    <message>
        <source>Closing the program does not stop the arm: it goes on to its target. Press the emergency stop if it must not.</source>
        <translation>关闭程序不会使机械臂停止，它会继续运动到目标点。若不允许，请按急停。</translation>
    </message>
    <message>
        <source>No motor holds it, or nothing told it to move. Closing the program does not hold it, and nobody tells any more how far it goes.</source>
        <translation>没有电机保持它，或没有任何指令让它运动。关闭程序不会保持它，也不再有人告知它走了多远。</translation>
    </message>
    <message>
        <source>Drag teaching is under way</source>
        <translation>示教正在进行</translation>
    </message>
    <message>
        <source>Closing the program ends a replay that was begun here, and nothing else: the arm goes on giving way to the hand and recording, or replaying. End it under Drag teaching first.</source>
        <translation>关闭程序只会结束由本程序开始的复现，其余不会结束：机械臂会继续随手拖动并录制，或继续复现。请先在“示教”面板结束。</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>仍然关闭</translation>
    </message>
</context>
<context>
    <name>ManualEntry</name>
    <message>
        <source>Interface</source>
        <translation>接口</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Add to the list</source>
        <translation>添加到列表</translation>
    </message>
    <message>
        <source>Enter the interface and its channel first.</source>
        <translation>请先输入接口和通道。</translation>
    </message>
</context>
<context>
    <name>MeasureChoice</name>
    <message>
        <source>Tells the gripper an angle.</source>
        <translation>按角度控制夹爪。</translation>
    </message>
    <message>
        <source>Set by</source>
        <translation>设定方式</translation>
    </message>
    <message>
        <source>Opening (mm)</source>
        <translation>开度（mm）</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>角度（°）</translation>
    </message>
</context>
<context>
    <name>MenuFoot</name>
    <message>
        <source>Help</source>
        <translation>使用帮助</translation>
    </message>
    <message>
        <source>How to use the 3D view</source>
        <translation>3D 区域的使用方法</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>视角还原</translation>
    </message>
    <message>
        <source>Restores the initial view</source>
        <translation>还原最初的 3D 显示视角</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Language, theme, jog step, 3D model</source>
        <translation>语言、主题、点动步长、3D 模型</translation>
    </message>
    <message>
        <source>Help: 3D view</source>
        <translation>使用帮助</translation>
    </message>
</context>
<context>
    <name>ModelChoice</name>
    <message>
        <source>The simulated arm is this model.</source>
        <translation>仿真机械臂即为所选型号。</translation>
    </message>
    <message>
        <source>No frame names the model: it is checked after connecting.</source>
        <translation>总线上没有型号信息：连接后会自动核对。</translation>
    </message>
    <message>
        <source>The pose this arm reports is that of a {fits}: choose it and press Connect.</source>
        <translation>该机械臂反馈的位姿属于 {fits}：请选择该型号并点击“连接”。</translation>
    </message>
    <message>
        <source>The pose this arm reports fits none of the models.</source>
        <translation>该机械臂反馈的位姿不符合任何型号。</translation>
    </message>
    <message>
        <source>Confirmed by the pose the arm reports.</source>
        <translation>与机械臂反馈的位姿一致，已确认。</translation>
    </message>
    <message>
        <source>Fits the pose the arm reports; so do others. Move a joint to decide.</source>
        <translation>符合机械臂反馈的位姿，但其他型号也符合。移动一个关节即可判定。</translation>
    </message>
    <message>
        <source>Not checked yet: the arm must stand still.</source>
        <translation>尚未核对：需要机械臂静止。</translation>
    </message>
    <message>
        <source>Model of the arm</source>
        <translation>机械臂型号</translation>
    </message>
    <message>
        <source>Its lengths decide where the tool is. The limits of the joints are always read from the arm.</source>
        <translation>型号决定各连杆长度，从而决定末端位置。关节限位始终从机械臂读取。</translation>
    </message>
    <message>
        <source>Last time this arm was a {before}: choose that and press Connect, or wait until the arm stands still and is checked.</source>
        <translation>此机械臂上次为 {before}：请选择该型号并点击连接，或等待机械臂静止后自动核对。</translation>
    </message>
</context>
<context>
    <name>ModelMark</name>
    <message>
        <source>{model}? The pose is that of a {other}</source>
        <translation>{model}？位姿属于 {other}</translation>
    </message>
    <message>
        <source>Click to connect it as a {other}.</source>
        <translation>点击以 {other} 重新连接。</translation>
    </message>
    <message>
        <source>{model}? The pose fits none</source>
        <translation>{model}？位姿不符合任何型号</translation>
    </message>
    <message>
        <source>The pose the arm reports fits none of the models.</source>
        <translation>机械臂反馈的位姿不符合任何型号。</translation>
    </message>
    <message>
        <source>Model of the arm, confirmed by the pose it reports.</source>
        <translation>机械臂型号，与反馈的位姿一致，已确认。</translation>
    </message>
    <message>
        <source>Model of the arm, as chosen; not checked yet.</source>
        <translation>机械臂型号（操作者选择），尚未核对。</translation>
    </message>
    <message>
        <source>Model of the arm: {text}</source>
        <translation>机械臂型号：{text}</translation>
    </message>
    <message>
        <source>{model}? It was a {before}</source>
        <translation>{model}？上次为 {before}</translation>
    </message>
    <message>
        <source>Last time this arm was a {before}. Click to choose.</source>
        <translation>此机械臂上次为 {before}。点击选择型号。</translation>
    </message>
    <message>
        <source>Joints 2 and 3 use the zeros from before S-V1.6-3.</source>
        <translation>关节 2、3 采用 S-V1.6-3 之前的零点。</translation>
    </message>
</context>
<context>
    <name>MotionEnd</name>
    <message>
        <source>the arm stopped before its target</source>
        <translation>机械臂未到目标即停下</translation>
    </message>
    <message>
        <source>the arm itself refused the target</source>
        <translation>机械臂自己拒绝了该目标</translation>
    </message>
    <message>
        <source>a newer command took its place</source>
        <translation>被新的指令取代</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已终止</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>motors without power</source>
        <translation>电机失能</translation>
    </message>
    <message>
        <source>another host moved the arm</source>
        <translation>其他程序移动了机械臂</translation>
    </message>
    <message>
        <source>drag teaching began</source>
        <translation>开始拖动示教</translation>
    </message>
    <message>
        <source>the arm left CAN control</source>
        <translation>机械臂退出 CAN 指令控制</translation>
    </message>
    <message>
        <source>no more feedback from the arm</source>
        <translation>收不到机械臂反馈</translation>
    </message>
    <message>
        <source>the joint limits changed</source>
        <translation>关节限位已改变</translation>
    </message>
    <message>
        <source>a zero was set</source>
        <translation>零点已重设</translation>
    </message>
    <message>
        <source>the arm stopped elsewhere</source>
        <translation>机械臂停在别处</translation>
    </message>
    <message>
        <source>its frames were not sent</source>
        <translation>报文未发出</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>已断开连接</translation>
    </message>
    <message>
        <source>the tool changed</source>
        <translation>工具已更改</translation>
    </message>
</context>
<context>
    <name>MotionPanel</name>
    <message>
        <source>Moves all joints to 0°.</source>
        <translation>各关节运动到 0°。</translation>
    </message>
    <message>
        <source>Fills the fields with the measured angles; nothing moves.</source>
        <translation>将当前测量角度填入编辑栏，机械臂不动。</translation>
    </message>
    <message>
        <source>Moves the arm to the angles in the fields.</source>
        <translation>使机械臂运动到编辑栏中的角度。</translation>
    </message>
    <message>
        <source>Motion control</source>
        <translation>运动控制</translation>
    </message>
    <message>
        <source>How far one press of − or + moves a joint</source>
        <translation>每按一次 − 或 + 关节转动的角度</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Take current</source>
        <translation>装载</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
</context>
<context>
    <name>MotorPanel</name>
    <message>
        <source>The arm will drop when it loses its power. Hold the arm.</source>
        <translation>失能后机械臂会下落，请扶住机械臂。</translation>
    </message>
    <message>
        <source>Disable all six motors</source>
        <translation>失能全部 6 个电机</translation>
    </message>
    <message>
        <source>Disable the motor of joint {joint}</source>
        <translation>失能关节 {joint} 电机</translation>
    </message>
    <message>
        <source>Joint {joint} and what hangs on it gives way.</source>
        <translation>关节 {joint} 及其后各部分将失去支撑。</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>失能</translation>
    </message>
    <message>
        <source>Set the zero of all six joints</source>
        <translation>设置全部 6 个关节的零点</translation>
    </message>
    <message>
        <source>Where all six joints stand now becomes their 0°.</source>
        <translation>6 个关节的当前位置将成为各自的 0°。</translation>
    </message>
    <message>
        <source>Set the zero of joint {joint}</source>
        <translation>设置关节 {joint} 的零点</translation>
    </message>
    <message>
        <source>Where joint {joint} stands now becomes its 0°.</source>
        <translation>关节 {joint} 的当前位置将成为其 0°。</translation>
    </message>
    <message>
        <source>The limits move with the zero, and so does every stored trajectory. With a wrong zero the arm runs into its stops.
Set it only at the mark of the joint&apos;s zero, with the arm standing still. The arm keeps it; there is no way back but to set it again.</source>
        <translation>限位和已存轨迹会随零点一起改变；零点设错，机械臂会撞上机械限位。
请仅在关节对准零位标记且机械臂静止时设置。机械臂会保存该零点，只能通过重新设置更改。</translation>
    </message>
    <message>
        <source>Set zero</source>
        <translation>零点设置</translation>
    </message>
    <message>
        <source>joint {joint}</source>
        <translation>关节 {joint}</translation>
    </message>
    <message>
        <source>all joints</source>
        <translation>全部关节</translation>
    </message>
    <message>
        <source>Motor settings</source>
        <translation>电机设置</translation>
    </message>
    <message>
        <source>All joints</source>
        <translation>全部关节</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>电机</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Clear error</source>
        <translation>清除错误</translation>
    </message>
    <message>
        <source>Gives the motor power: it holds its position.</source>
        <translation>给电机上电，电机保持当前位置。</translation>
    </message>
    <message>
        <source>Cuts the motor&apos;s power: the arm drops. Asks first.</source>
        <translation>切断电机动力，机械臂会下落。执行前会询问。</translation>
    </message>
    <message>
        <source>Makes the present position the joint&apos;s zero. Asks first.</source>
        <translation>将关节当前位置设为零点。执行前会询问。</translation>
    </message>
    <message>
        <source>Clears the error of the joint&apos;s driver; nothing moves.</source>
        <translation>清除关节驱动器的错误，机械臂不会运动。</translation>
    </message>
</context>
<context>
    <name>MotorRow</name>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>已失能</translation>
    </message>
    <message>
        <source>Motor temperature of joint {joint}</source>
        <translation>关节 {joint} 电机温度</translation>
    </message>
    <message>
        <source>Driver temperature of joint {joint}</source>
        <translation>关节 {joint} 驱动器温度</translation>
    </message>
    <message>
        <source>Motor current of joint {joint}</source>
        <translation>关节 {joint} 电机电流</translation>
    </message>
    <message>
        <source>Supply voltage of joint {joint}</source>
        <translation>关节 {joint} 电源电压</translation>
    </message>
    <message>
        <source>State of motor {joint}</source>
        <translation>电机 {joint} 状态</translation>
    </message>
</context>
<context>
    <name>Mounting</name>
    <message>
        <source>Unchanged</source>
        <translation>不变</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>左侧</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>右侧</translation>
    </message>
    <message>
        <source>Upside down</source>
        <translation>水平倒装</translation>
    </message>
    <message>
        <source>The base is placed for the mounting “{needed}”, which the arm was not told: it would hold its weight wrongly. Tell it under End load; the program never does so by itself.</source>
        <translation>底座按“{needed}”安装放置，但还没有告知机械臂：它会错误地托住自重。请在“末端负载”中告知；程序不会自行发送。</translation>
    </message>
    <message>
        <source>The base is tilted so that no mounting fits that the arm knows: it holds its weight wrongly. Correct the figures, or mind it when the arm is led by hand.</source>
        <translation>底座的倾斜不符合机械臂支持的任何安装方式：它会错误地托住自重。请更正数值；否则拖动时请当心。</translation>
    </message>
    <message>
        <source>The arm was told the mounting “{told}”, but the cell places its base for “{needed}”: one of them is wrong. Correct the figures, or tell the arm under End load.</source>
        <translation>已告知机械臂的安装方式是“{told}”，而单元中底座按“{needed}”放置：两者必有一错。请更正数值，或在“末端负载”中重新告知。</translation>
    </message>
</context>
<context>
    <name>MountingCard</name>
    <message>
        <source>Tell the arm its mounting: {mounting}</source>
        <translation>告知机械臂安装方式：{mounting}</translation>
    </message>
    <message>
        <source>The arm carries its own weight by what it believes of its mounting. If that is wrong it may sink or rise when it is led by hand, hold badly, and stop for collisions that are none.
It takes this over at once. Compare with how the arm really stands, and keep clear.</source>
        <translation>机械臂按所设的安装方式补偿自重。若设置错误，拖动时可能下沉或上浮，保持不稳，并可能误报碰撞而停止。
设置立即生效。请核对机械臂的实际安装方式，并远离机械臂。</translation>
    </message>
    <message>
        <source>Set mounting…</source>
        <translation>设置安装方式…</translation>
    </message>
    <message>
        <source>Tells the arm how it is mounted. Asks first.</source>
        <translation>告知机械臂其安装方式。会先询问。</translation>
    </message>
    <message>
        <source>Choose how the arm is mounted first.</source>
        <translation>请先选择机械臂的安装方式。</translation>
    </message>
    <message>
        <source>Mounting of the arm</source>
        <translation>机械臂安装方式</translation>
    </message>
    <message>
        <source>The picture and the check of the floor take the base as upright all the same: place it under Cell, Base.</source>
        <translation>画面和地面检查仍按底座正立计算：请在“单元”的“底座”中设置其位置。</translation>
    </message>
    <message>
        <source>The arm does not answer this and cannot be asked for it: another program, or the arm itself after a power cut, may have another one.</source>
        <translation>机械臂对此不应答，也无法查询：其他程序或断电后的机械臂可能采用不同的设置。</translation>
    </message>
    <message>
        <source>Mounting: not set from here yet</source>
        <translation>安装方式：本程序尚未设置</translation>
    </message>
    <message>
        <source>Mounting, as last set from here: {mounting}</source>
        <translation>安装方式：本程序上次设为{mounting}</translation>
    </message>
</context>
<context>
    <name>MoveMode</name>
    <message>
        <source>Point mode</source>
        <translation>点位模式</translation>
    </message>
    <message>
        <source>Joint mode</source>
        <translation>关节模式</translation>
    </message>
    <message>
        <source>Linear mode</source>
        <translation>直线模式</translation>
    </message>
    <message>
        <source>Arc mode</source>
        <translation>圆弧模式</translation>
    </message>
    <message>
        <source>MIT mode</source>
        <translation>MIT 模式</translation>
    </message>
    <message>
        <source>CPV mode</source>
        <translation>CPV 模式</translation>
    </message>
</context>
<context>
    <name>NameBar</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>NamedTab</name>
    <message>
        <source>Undo delete</source>
        <translation>撤销删除</translation>
    </message>
    <message>
        <source>The arm has not reported its pose yet.</source>
        <translation>机械臂尚未反馈位姿。</translation>
    </message>
    <message>
        <source>Type a name first.</source>
        <translation>请先输入名称。</translation>
    </message>
    <message>
        <source>Nothing is changed.</source>
        <translation>没有改动。</translation>
    </message>
    <message>
        <source>Restores “{name}”.</source>
        <translation>恢复“{name}”。</translation>
    </message>
    <message>
        <source>{kind}: edge along {axis}</source>
        <translation>{kind}：沿 {axis} 的边长</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>Notice</name>
    <message>
        <source>Sent J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  J6 {j6}°</source>
        <translation>已发送 J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  J6 {j6}°</translation>
    </message>
    <message>
        <source>Sent J{joint} {target}°</source>
        <translation>已发送 J{joint} {target}°</translation>
    </message>
    <message>
        <source>Home sent: all joints to 0°</source>
        <translation>已发送回零：各关节运动到 0°</translation>
    </message>
    <message>
        <source>Sent speed {percent} %</source>
        <translation>已发送速度 {percent} %</translation>
    </message>
    <message>
        <source>Run pauses in row {row}</source>
        <translation>在第 {row} 行暂停</translation>
    </message>
    <message>
        <source>The arm has NOT confirmed the emergency stop; it is sent again and again. Cut the arm&apos;s power if it moves.</source>
        <translation>机械臂尚未确认急停，正在反复发送。若机械臂仍在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>The emergency stop is over. Enable the motors to go on.</source>
        <translation>急停已解除。使能电机后可继续使用。</translation>
    </message>
    <message>
        <source>Jogging J{joint} {sign}</source>
        <translation>点动 J{joint} {sign}</translation>
    </message>
    <message>
        <source>Jogging {axis} {sign}</source>
        <translation>点动 {axis} {sign}</translation>
    </message>
    <message>
        <source>Jogging ended. {reason}</source>
        <translation>点动已结束。{reason}</translation>
    </message>
    <message>
        <source>Sent MOVE C through the three captured poses</source>
        <translation>已发送 MOVE C：经过记录的三个位姿</translation>
    </message>
    <message>
        <source>Sent a step of {step} along {axis}</source>
        <translation>已发送 {axis} 步进 {step}</translation>
    </message>
    <message>
        <source>{percent} % is kept: the arm gets it when the motion held back goes on</source>
        <translation>{percent} % 已记下：被保留的运动继续时才发送给机械臂</translation>
    </message>
    <message>
        <source>Another program controls the arm ({frames}).</source>
        <translation>另一程序正在控制机械臂（{frames}）。</translation>
    </message>
    <message>
        <source>A leader arm moves this arm ({frames}).</source>
        <translation>主臂正在带动本机械臂（{frames}）。</translation>
    </message>
    <message>
        <source>Nobody else controls the arm any more.</source>
        <translation>已没有其他程序控制机械臂。</translation>
    </message>
    <message>
        <source>Connected as a {chosen}, but the pose it reports is that of a {fits}. Connect it as a {fits}.</source>
        <translation>连接时选择的型号是 {chosen}，但其反馈的位姿属于 {fits}。请按 {fits} 重新连接。</translation>
    </message>
    <message>
        <source>The pose the arm reports fits its angles in no model of the family, {chosen} included.</source>
        <translation>机械臂反馈的位姿与关节角度不符合任何型号（包括 {chosen}）。</translation>
    </message>
    <message>
        <source>Taken over: this program may move the arm.</source>
        <translation>已接管：本程序可以移动机械臂。</translation>
    </message>
    <message>
        <source>Speed override {percent} %</source>
        <translation>运行倍率 {percent} %</translation>
    </message>
    <message>
        <source>The arm was told to end its motion and still moves. Stop it, or cut its power.</source>
        <translation>已命令机械臂终止运动，但它仍在动。请急停，或切断其电源。</translation>
    </message>
    <message>
        <source>Motion ended: too fast. {reason}</source>
        <translation>运动已终止：速度过快。{reason}</translation>
    </message>
    <message>
        <source>Sent to lamp {lamp} of joint {joint}: {color}</source>
        <translation>已发送关节 {joint} 灯珠 {lamp}：{color}</translation>
    </message>
    <message>
        <source>Sent to all lamps of joint {joint}: {color}</source>
        <translation>已发送关节 {joint} 全部灯珠：{color}</translation>
    </message>
    <message>
        <source>Enable sent to all six motors</source>
        <translation>已向 6 个电机发送使能</translation>
    </message>
    <message>
        <source>All six motors are enabled.</source>
        <translation>6 个电机均已使能。</translation>
    </message>
    <message>
        <source>These joints did not enable: {joints}. Press Enable again; if that fails, check their drivers and the arm&apos;s power.</source>
        <translation>以下关节未能使能：{joints}。请再按一次“使能”；若仍失败，请检查其驱动器和机械臂电源。</translation>
    </message>
    <message>
        <source>Enable sent to joint {joint}</source>
        <translation>已发送关节 {joint} 使能</translation>
    </message>
    <message>
        <source>Joint {joint} is enabled.</source>
        <translation>关节 {joint} 已使能。</translation>
    </message>
    <message>
        <source>Disable sent to joint {joint}</source>
        <translation>已发送关节 {joint} 失能</translation>
    </message>
    <message>
        <source>Joint {joint} is disabled.</source>
        <translation>关节 {joint} 已失能。</translation>
    </message>
    <message>
        <source>Disable sent to all six motors. The arm drops: hold the arm.</source>
        <translation>已向 6 个电机发送失能。机械臂会下落，请扶住机械臂。</translation>
    </message>
    <message>
        <source>All six motors are disabled.</source>
        <translation>6 个电机均已失能。</translation>
    </message>
    <message>
        <source>These joints did not disable: {joints}. Press Disable again, or use the emergency stop.</source>
        <translation>以下关节未能失能：{joints}。请再按一次“失能”，或使用急停。</translation>
    </message>
    <message>
        <source>Clear error sent to joint {joint}</source>
        <translation>已向关节 {joint} 发送清除错误</translation>
    </message>
    <message>
        <source>Joint {joint}: the arm has confirmed the command to clear the error. Where a fault is still shown, remove its cause, then clear it again.</source>
        <translation>关节 {joint}：机械臂已应答清除错误指令。若仍显示故障，请先排除原因，再次清除。</translation>
    </message>
    <message>
        <source>Joint {joint}: the arm did not confirm within a second the command to clear the error. Try again; if it stays silent, check the CAN cable.</source>
        <translation>关节 {joint}：机械臂在 1 秒内没有应答清除错误指令。请重试；若仍无应答，请检查 CAN 线缆。</translation>
    </message>
    <message>
        <source>End load sent: {load}</source>
        <translation>已发送末端负载：{load}</translation>
    </message>
    <message>
        <source>The arm has come too near to “{name}” of the work area: {part}, by {value} mm.</source>
        <translation>机械臂离工作区的“{name}”过近：{part}，差 {value} mm。</translation>
    </message>
    <message>
        <source>The arm stands too near to “{name}” of the work area as it is now: {part}, by {value} mm.</source>
        <translation>机械臂离工作区当前的“{name}”过近：{part}，差 {value} mm。</translation>
    </message>
    <message>
        <source>After an emergency stop the arm may sink, and the work area does not hold it: below it is {names}. Hold the arm.</source>
        <translation>急停后机械臂可能下沉，工作区拦不住它：其下方是 {names}。请扶住机械臂。</translation>
    </message>
    <message>
        <source>From here on the gripper holds “{name}”.</source>
        <translation>从此刻起夹爪夹着“{name}”。</translation>
    </message>
    <message>
        <source>From here on the gripper holds nothing.</source>
        <translation>从此刻起夹爪未夹工件。</translation>
    </message>
    <message>
        <source>The arm has answered the end load: {load}. It cannot be asked for it.</source>
        <translation>机械臂已应答末端负载：{load}（无法查询核对）。</translation>
    </message>
    <message>
        <source>End load not confirmed. {reason}</source>
        <translation>末端负载未得到确认。{reason}</translation>
    </message>
    <message>
        <source>Switching the feedback of the end&apos;s motion</source>
        <translation>正在切换末端速度/加速度反馈</translation>
    </message>
    <message>
        <source>The arm reports the motion of its end.</source>
        <translation>机械臂正在上报末端速度/加速度。</translation>
    </message>
    <message>
        <source>The arm no longer reports the motion of its end.</source>
        <translation>机械臂已停止上报末端速度/加速度。</translation>
    </message>
    <message>
        <source>The feedback of the end&apos;s motion is not switched. {reason}</source>
        <translation>末端速度/加速度反馈未切换成功。{reason}</translation>
    </message>
    <message>
        <source>Linkage setting sent</source>
        <translation>已发送联动设置</translation>
    </message>
    <message>
        <source>The arm has acknowledged the linkage setting. It takes effect in standby, or after a power cycle.</source>
        <translation>机械臂已应答联动设置，在待机模式下或重新上电后生效。</translation>
    </message>
    <message>
        <source>Release sent. The motors no longer brake and the arm drops: hold the arm.</source>
        <translation>解除急停已发送。电机不再有阻尼，机械臂会下落，请扶住机械臂。</translation>
    </message>
    <message>
        <source>The arm has answered: it becomes a teaching input. Its feedback ends and it can be led by hand.</source>
        <translation>机械臂已应答：将成为示教输入臂，反馈停止，可用手拖动。</translation>
    </message>
    <message>
        <source>Linkage setting not confirmed. {reason}</source>
        <translation>联动设置未得到确认。{reason}</translation>
    </message>
    <message>
        <source>Identifiers in use: feedback from {feedback}, commands from {control}.</source>
        <translation>当前使用的 ID：反馈从 {feedback} 起，控制从 {control} 起。</translation>
    </message>
    <message>
        <source>An arm is heard with its feedback from {feedback}. On which identifiers it takes commands is not known: set them under Linkage control.</source>
        <translation>收到机械臂的反馈，ID 从 {feedback} 起。其控制指令 ID 未知，请在“联动控制”中设置。</translation>
    </message>
    <message>
        <source>Gripper: sent to {value} {unit}</source>
        <translation>夹爪：已发送 {value} {unit}</translation>
    </message>
    <message>
        <source>Nothing is kept in these folders: {folders}. Let this user write there; Diagnosis gives the command.</source>
        <translation>以下文件夹中什么都无法保存：{folders}。请允许当前用户写入；“诊断”给出命令。</translation>
    </message>
    <message>
        <source>Cell renamed: {name}</source>
        <translation>单元已改名：{name}</translation>
    </message>
    <message>
        <source>The same arm answers after {seconds} s of silence: the cell “{name}” stays in force.</source>
        <translation>无反馈 {seconds} s 后应答的是同一台机械臂：单元“{name}”继续生效。</translation>
    </message>
    <message>
        <source>The gripper has opened to {value} mm. “{name}” counts as held until it is let go under Cell, Held.</source>
        <translation>夹爪已张开到 {value} mm。在“单元”的“工件”中标为“已放下”之前，“{name}”仍算夹着。</translation>
    </message>
    <message>
        <source>Cell: {reason}</source>
        <translation>单元：{reason}</translation>
    </message>
    <message>
        <source>Not done. {reason}</source>
        <translation>未执行。{reason}</translation>
    </message>
    <message>
        <source>The gripper is at {value} {unit}.</source>
        <translation>夹爪已到 {value} {unit}。</translation>
    </message>
    <message>
        <source>The gripper holds something at {value} {unit}, with {torque} N·m.</source>
        <translation>夹爪在 {value} {unit} 处夹住物体，力矩 {torque} N·m。</translation>
    </message>
    <message>
        <source>The gripper stopped at {value} {unit} instead of {target} {unit}. Check what blocks it, its errors and its power.</source>
        <translation>夹爪停在 {value} {unit}，未到 {target} {unit}。请检查是否受阻、有无错误以及供电。</translation>
    </message>
    <message>
        <source>The gripper was told to stay where it is, at {value} {unit}.</source>
        <translation>已令夹爪停在原处：{value} {unit}。</translation>
    </message>
    <message>
        <source>Gripper: {act} sent</source>
        <translation>夹爪：已发送{act}</translation>
    </message>
    <message>
        <source>Gripper: {act} done, by its own feedback.</source>
        <translation>夹爪：{act}已完成（以其反馈为准）。</translation>
    </message>
    <message>
        <source>Gripper: {act} has had no effect. Check its errors, its power and its cable, then try again.</source>
        <translation>夹爪：{act}没有生效。请检查其错误、供电和线缆后重试。</translation>
    </message>
    <message>
        <source>Zero setting sent to all six joints</source>
        <translation>已发送全部 6 个关节的零点设置</translation>
    </message>
    <message>
        <source>Zero setting sent to joint {joint}</source>
        <translation>已发送关节 {joint} 的零点设置</translation>
    </message>
    <message>
        <source>The arm has set the zeros of all six joints; their angles now read 0.</source>
        <translation>机械臂已设置全部 6 个关节的零点，角度现读为 0。</translation>
    </message>
    <message>
        <source>The arm has set the zero of joint {joint}; its angle now reads 0.</source>
        <translation>机械臂已设置关节 {joint} 的零点，角度现读为 0。</translation>
    </message>
    <message>
        <source>Zero setting failed. {reason}</source>
        <translation>零点设置失败。{reason}</translation>
    </message>
    <message>
        <source>Connection to {device} lost: the arm is not heard, and it may be moving. The program keeps trying to reconnect. {reason}</source>
        <translation>与 {device} 的连接断开：收不到反馈，机械臂可能仍在运动。程序会不断尝试重新连接。{reason}</translation>
    </message>
    <message>
        <source>Nothing is heard. {reason}</source>
        <translation>听不到任何帧。{reason}</translation>
    </message>
    <message>
        <source>{device} hears frames again</source>
        <translation>{device} 又能收到帧了</translation>
    </message>
    <message>
        <source>Another armui on this computer uses the same settings file. What is changed here is kept. What is kept there of single arms and devices is followed here at once; other changes made there appear at the next start.</source>
        <translation>本机另一个 armui 正在使用同一设置文件。此处的更改会保留。那边为各机械臂和设备保存的内容在此立即跟随；那边的其他更改在下次启动时生效。</translation>
    </message>
    <message>
        <source>Feedback arrived late: no joint angles came for {value} ms. The computer, the adapter or the bus was busy; nothing about the arm is concluded from that.</source>
        <translation>反馈延迟到达：{value} ms 内没有收到关节角度。电脑、适配器或总线繁忙；不据此判断机械臂的状态。</translation>
    </message>
    <message>
        <source>The arm is offline: nothing is heard from it, and it may still be moving. This computer itself stood still for {value} ms meanwhile: close what keeps it busy. If this comes again on a quiet computer, check the arm&apos;s power, the CAN cable and the bit rate.</source>
        <translation>机械臂离线：收不到它的任何数据，它可能仍在运动。本机在此期间自己停顿了 {value} ms：请关闭占用电脑的程序。若在空闲的电脑上仍出现，请检查机械臂的电源、CAN 线和波特率。</translation>
    </message>
    <message>
        <source>Sent MOVE P (base) to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°</source>
        <translation>已发送 MOVE P：基坐标系 X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°</translation>
    </message>
    <message>
        <source>Sent MOVE L (base) to X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°</source>
        <translation>已发送 MOVE L：基坐标系 X {x}  Y {y}  Z {z} mm  RX {rx}°  RY {ry}°  RZ {rz}°</translation>
    </message>
    <message>
        <source>{device} jogs {axes} (user frame “{frame}”)</source>
        <translation>{device} 点动 {axes}（用户坐标系“{frame}”）</translation>
    </message>
    <message>
        <source>“{device}” streams targets</source>
        <translation>“{device}”正在流式发送目标</translation>
    </message>
    <message>
        <source>The arm is brought inside its limits: J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  J6 {j6}°</source>
        <translation>机械臂回到限位内：J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  J6 {j6}°</translation>
    </message>
    <message>
        <source>J{joint} stood outside its limits: the arm brings it to {target}° at least.</source>
        <translation>J{joint} 位于限位之外：机械臂至少会将其移动到 {target}°。</translation>
    </message>
    <message>
        <source>Settings sent to the arm: {count}</source>
        <translation>已向机械臂发送 {count} 项参数</translation>
    </message>
    <message>
        <source>Settings saved and read back: {settings}</source>
        <translation>设置已保存并回读：{settings}</translation>
    </message>
    <message>
        <source>{count} of {total} settings did not take effect. {reason}</source>
        <translation>{total} 项参数中有 {count} 项未生效。{reason}</translation>
    </message>
    <message>
        <source>Restoring the factory values</source>
        <translation>已发送初始化指令</translation>
    </message>
    <message>
        <source>The arm has confirmed its factory values; the fields show what is read back.</source>
        <translation>机械臂已应答恢复出厂值，输入框中为回读的数值。</translation>
    </message>
    <message>
        <source>The arm stays in emergency stop. Check it, then hold Release again.</source>
        <translation>机械臂仍处于急停状态。请检查机械臂，然后再按住“解除急停”。</translation>
    </message>
    <message>
        <source>Release was sent, and the arm&apos;s status was not heard after it: whether the stop is over is not known. Look at the line above the panels.</source>
        <translation>解除急停已发送，但之后未收到机械臂状态：急停是否已解除尚不可知。请看面板上方的提示行。</translation>
    </message>
    <message>
        <source>The arm is offline: nothing is heard from it, and it may still be moving. Check its power, the CAN cable and the bit rate.</source>
        <translation>机械臂离线：没有收到反馈，它可能仍在运动。请检查机械臂电源、CAN 线和波特率。</translation>
    </message>
    <message>
        <source>Running “{name}”</source>
        <translation>开始执行“{name}”</translation>
    </message>
    <message>
        <source>Paused: the arm is measured at rest, and holds.</source>
        <translation>已暂停：测得机械臂静止，保持位置。</translation>
    </message>
    <message>
        <source>Joint inspection finished: nothing stands out.</source>
        <translation>关节巡检完成：无异常。</translation>
    </message>
    <message>
        <source>Joint inspection finished: joint {joints} stands out. The report says by what.</source>
        <translation>关节巡检完成：关节 {joints} 异常，报告中有说明。</translation>
    </message>
    <message>
        <source>Joint inspection over; joint {joints} was not measured. The report says why.</source>
        <translation>关节巡检结束；关节 {joints} 未测量，报告中有原因。</translation>
    </message>
    <message>
        <source>The arm lies outside its limits: it is brought inside first, slowly.</source>
        <translation>机械臂位于限位之外：先缓慢回到限位内。</translation>
    </message>
    <message>
        <source>Run continues in row {row}</source>
        <translation>从第 {row} 行继续执行</translation>
    </message>
    <message>
        <source>Replay pauses</source>
        <translation>回放暂停</translation>
    </message>
    <message>
        <source>The run goes at {percent} %</source>
        <translation>运行速度 {percent} %</translation>
    </message>
    <message>
        <source>The speed at the top is lowered from {before} to {percent} % as the run begins</source>
        <translation>开始运行：顶部的速度由 {before} 降为 {percent} %</translation>
    </message>
    <message>
        <source>Checking the way…</source>
        <translation>正在检查路径…</translation>
    </message>
    <message>
        <source>The arm did not react. Look at the line above the panels.</source>
        <translation>机械臂无响应。请查看面板上方的提示。</translation>
    </message>
    <message>
        <source>Reference check left without a result: it counts as not done.</source>
        <translation>零位基准检查未完成便已退出，视为未检查。</translation>
    </message>
    <message>
        <source>At the resume the feedback jumped: {joints}. By so much the joint stood elsewhere than it reported. What was set as zero, saved or taught before may be off by it: check the reference, and set zeros only now.</source>
        <translation>解除急停时反馈突跳：{joints}。此前该关节的实际位置与上报相差这么多。之前设置的零点、保存或示教的点可能有同样偏差：请检查零位基准，零点只应在此之后设置。</translation>
    </message>
    <message>
        <source>The arm sinks, and no motor holds it. Hold it. Below it: {below}.</source>
        <translation>机械臂正在下沉，没有电机支撑。请扶住。下方：{below}。</translation>
    </message>
    <message>
        <source>No motor holds joint {joint}, and the arm gives way there. Hold it. Below it: {below}.</source>
        <translation>关节 {joint} 没有电机支撑，机械臂在此处松动。请扶住。下方：{below}。</translation>
    </message>
    <message>
        <source>The arm sinks though its motors are on. Hold it. Below it: {below}.</source>
        <translation>电机已使能，但机械臂仍在下沉。请扶住。下方：{below}。</translation>
    </message>
    <message>
        <source>The arm sinks on: {down} mm in {seconds} s, joint {joint} by {turned}°, now at {speed} mm/s.</source>
        <translation>机械臂继续下沉：{seconds} 秒内下沉 {down} mm，关节 {joint} 转动 {turned}°，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm moves, and no motor holds it: joint {joint} by {turned}°.</source>
        <translation>机械臂在运动，且没有电机支撑：关节 {joint} 转动 {turned}°。</translation>
    </message>
    <message>
        <source>The arm moves, and nothing told it to: joint {joint} by {turned}°.</source>
        <translation>没有任何指令，机械臂却在运动：关节 {joint} 转动 {turned}°。</translation>
    </message>
    <message>
        <source>The arm moves on: joint {joint} by {turned}° in {seconds} s, now at {speed} mm/s.</source>
        <translation>机械臂继续运动：{seconds} 秒内关节 {joint} 转动 {turned}°，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm is measured at rest: in {seconds} s it came down by {down} mm, joint {joint} turned by {turned}°.</source>
        <translation>测得机械臂已静止：{seconds} 秒内下降 {down} mm，关节 {joint} 转动 {turned}°。</translation>
    </message>
    <message>
        <source>The arm is held again: in {seconds} s it came down by {down} mm, joint {joint} turned by {turned}°.</source>
        <translation>机械臂重新被电机支撑：{seconds} 秒内下降 {down} mm，关节 {joint} 转动 {turned}°。</translation>
    </message>
    <message>
        <source>The arm moved at {speed} mm/s when it was last heard: it may be moving.</source>
        <translation>最后一次收到反馈时机械臂以 {speed} mm/s 运动：它可能仍在运动。</translation>
    </message>
    <message>
        <source>Emergency stop sent. The motors only brake and the arm sinks: hold the arm.</source>
        <translation>急停已发送。电机只起阻尼作用，机械臂会缓慢下沉，请扶住机械臂。</translation>
    </message>
    <message>
        <source>The outstanding emergency stop was withdrawn; the arm has not confirmed it.</source>
        <translation>未完成的急停已撤销；机械臂尚未确认急停。</translation>
    </message>
    <message>
        <source>Episode {number} begun: “{task}”</source>
        <translation>片段 {number} 开始：“{task}”</translation>
    </message>
    <message>
        <source>Episode {number} ended, {seconds} s</source>
        <translation>片段 {number} 结束，{seconds} s</translation>
    </message>
    <message>
        <source>Episode {number} was not ended: it ends with the log, after {seconds} s</source>
        <translation>片段 {number} 没有结束标记：随日志一起结束，共 {seconds} s</translation>
    </message>
    <message>
        <source>Episode {number} discarded</source>
        <translation>片段 {number} 已弃用</translation>
    </message>
    <message>
        <source>{count} frames are missing in the log: the disk is too slow</source>
        <translation>日志中缺少 {count} 帧：磁盘太慢</translation>
    </message>
    <message>
        <source>“{client}” asks for the arm: {purpose}</source>
        <translation>“{client}”申请机械臂：{purpose}</translation>
    </message>
    <message>
        <source>The operator has granted “{client}” the arm, at most at {percent} %.</source>
        <translation>操作员已授予“{client}”机械臂，最高 {percent} %。</translation>
    </message>
    <message>
        <source>“{client}” no longer moves the arm. {reason}</source>
        <translation>“{client}”不再操作机械臂。{reason}</translation>
    </message>
    <message>
        <source>“{client}” was not granted the arm. {reason}</source>
        <translation>“{client}”未获授予机械臂。{reason}</translation>
    </message>
    <message>
        <source>The operator has let “{client}” do it: {operation}</source>
        <translation>操作员已允许“{client}”：{operation}</translation>
    </message>
    <message>
        <source>Park position set: {angles}</source>
        <translation>停放位已设定：{angles}</translation>
    </message>
    <message>
        <source>The emergency stop was undone, and not by this program: another host has released the arm, or it was switched off and on. Press the emergency stop again if it must stay.</source>
        <translation>急停被解除，但不是本程序所为：另一程序解除了急停，或机械臂断电后重新上电。若必须保持停止，请再按急停。</translation>
    </message>
    <message>
        <source>The arm has confirmed the emergency stop. Release stands in the line of the next step.</source>
        <translation>机械臂已确认急停。解除急停的按钮在面板上方的下一步提示行中。</translation>
    </message>
    <message>
        <source>“{name}” has finished.</source>
        <translation>“{name}”执行完毕。</translation>
    </message>
    <message>
        <source>Run ended in row {row}; the arm is at rest.</source>
        <translation>已在第 {row} 行结束执行，机械臂已停稳。</translation>
    </message>
    <message>
        <source>Run ended in row {row}. {reason}</source>
        <translation>在第 {row} 行中止执行。{reason}</translation>
    </message>
    <message>
        <source>Sent: {command}</source>
        <translation>已发送：{command}</translation>
    </message>
    <message>
        <source>The arm has confirmed: {command}</source>
        <translation>机械臂已确认：{command}</translation>
    </message>
    <message>
        <source>The arm did not follow within 1.5 s: {command}. Look at its status; if it has no recording, record first.</source>
        <translation>机械臂 1.5 秒内未执行：{command}。请查看状态；若没有示教轨迹，请先记录。</translation>
    </message>
    <message>
        <source>Sent: {plan}. The arm does not report this; watch it.</source>
        <translation>已发送：{plan}。机械臂不反馈此指令，请观察机械臂。</translation>
    </message>
    <message>
        <source>Standby sent</source>
        <translation>已发送：待机模式</translation>
    </message>
    <message>
        <source>Sent: motion output (0xFC)</source>
        <translation>已发送：设置为运动输出臂（0xFC）</translation>
    </message>
    <message>
        <source>Replay continues</source>
        <translation>继续回放</translation>
    </message>
    <message>
        <source>Replay of “{name}” ended; the arm is at rest.</source>
        <translation>“{name}”回放已结束，机械臂已停稳。</translation>
    </message>
    <message>
        <source>Replay ended. {reason}</source>
        <translation>回放中止。{reason}</translation>
    </message>
    <message>
        <source>Recording the arm&apos;s motion</source>
        <translation>开始录制机械臂运动</translation>
    </message>
    <message>
        <source>Recorded: {count} samples over {seconds} s</source>
        <translation>录制完成：{count} 个采样，{seconds} 秒</translation>
    </message>
    <message>
        <source>“{client}” asks: {operation}</source>
        <translation>“{client}”请求：{operation}</translation>
    </message>
    <message>
        <source>No live stream: {reason}</source>
        <translation>实时数据流不可用：{reason}</translation>
    </message>
    <message>
        <source>Also saved as MF4: {name}.mf4</source>
        <translation>已另存为 MF4：{name}.mf4</translation>
    </message>
    <message>
        <source>No .mf4 file of {name}: {reason} The recording is whole as .blf.</source>
        <translation>{name} 未生成 .mf4 文件：{reason} .blf 记录完整无缺。</translation>
    </message>
    <message>
        <source>Device open: {device}</source>
        <translation>设备已打开：{device}</translation>
    </message>
    <message>
        <source>Not connected. {reason}</source>
        <translation>未能连接。{reason}</translation>
    </message>
    <message>
        <source>Disconnected from {device}</source>
        <translation>已断开 {device}</translation>
    </message>
    <message>
        <source>Connected to {device} again</source>
        <translation>已重新连接 {device}</translation>
    </message>
    <message>
        <source>The arm is online.</source>
        <translation>机械臂在线。</translation>
    </message>
    <message>
        <source>The arm speaks protocol generation {generation}. Firmware: {firmware}</source>
        <translation>机械臂使用第 {generation} 代协议，固件版本：{firmware}</translation>
    </message>
    <message>
        <source>Joint limits read from the arm</source>
        <translation>已读取机械臂的关节限位</translation>
    </message>
    <message>
        <source>The arm did not tell the limits of these joints: {joints}. The factory limits hold; connect again to ask once more.</source>
        <translation>未读到以下关节的限位：{joints}。现按出厂限位检查；重新连接可再次读取。</translation>
    </message>
    <message>
        <source>Joint {joint}: the limits stored in the arm cannot be true. The factory limits hold; set the joint&apos;s limits anew.</source>
        <translation>关节 {joint}：机械臂中保存的限位不合理。现按出厂限位检查；请重新设置该关节的限位。</translation>
    </message>
    <message>
        <source>Not sent. {reason}</source>
        <translation>未发送。{reason}</translation>
    </message>
    <message>
        <source>Event: {code}</source>
        <translation>事件：{code}</translation>
    </message>
    <message>
        <source>The emergency stop is NOT on the bus: no CAN device is open, or it does not take the frame. Cut the arm&apos;s power if it moves.</source>
        <translation>急停没有发到总线上：没有打开 CAN 设备，或设备不接收该帧。若机械臂在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>A second arm is heard on this bus (feedback at {feedback}): the stop reaches it, too.</source>
        <translation>总线上还有第二台机械臂（反馈 {feedback}）：急停也会到达它。</translation>
    </message>
    <message>
        <source>A stop is outstanding: the arm was away for more than 10 seconds and has not confirmed it. It is not sent by itself any more. Press the emergency stop if the arm must stop.</source>
        <translation>有一次急停未完成：机械臂离线超过 10 秒，没有确认。程序不再自动发送。若机械臂必须停止，请按急停。</translation>
    </message>
    <message>
        <source>The arm on {device} has never confirmed its emergency stop, and another device is connected now. Cut that arm&apos;s power if it moves.</source>
        <translation>{device} 上的机械臂一直没有确认急停，而现在连接的是另一设备。若那台机械臂在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>Halt sent: the motion ends, the motors keep their power.</source>
        <translation>已发送停住：运动结束，电机保持上电。</translation>
    </message>
    <message>
        <source>The halt is NOT on the bus yet: the adapter does not take it. It goes out as soon as that is possible. Press the emergency stop if the arm moves.</source>
        <translation>停住还没有发到总线上：适配器不接收。一旦可能就会发出。若机械臂在运动，请按急停。</translation>
    </message>
    <message>
        <source>The arm stands still and holds.</source>
        <translation>机械臂已静止并保持。</translation>
    </message>
    <message>
        <source>{device} sends nothing. {reason}</source>
        <translation>{device} 发不出任何帧。{reason}</translation>
    </message>
    <message>
        <source>{device} sends again. What had waited was dropped, but for a stop.</source>
        <translation>{device} 又能发送了。此前等待的帧已丢弃，急停除外。</translation>
    </message>
    <message>
        <source>Another armui on this computer is connected to {device}, too. Both can move the arm: close one of them.</source>
        <translation>本机另一个 armui 也已连接 {device}。两者都能移动机械臂：请关闭其中一个。</translation>
    </message>
    <message>
        <source>{count} frames were lost before the program could read them ({total} since connecting): the computer is too busy, or the adapter too slow.</source>
        <translation>有 {count} 帧在程序读取之前丢失（连接以来共 {total} 帧）：电脑太忙，或适配器太慢。</translation>
    </message>
    <message>
        <source>The arm has not taken the last motion: it is heard, and does not move. It may listen under another control offset (Linkage control), or a frame was lost.</source>
        <translation>机械臂未执行刚才的运动：有反馈，但没有动。它可能在另一个控制偏移下接收指令（见联动控制），或有帧丢失。</translation>
    </message>
    <message>
        <source>The arm has not confirmed its factory values. {reason}</source>
        <translation>机械臂未确认恢复出厂值。{reason}</translation>
    </message>
    <message>
        <source>Sent by hand: {frame}. It counts as another program&apos;s command.</source>
        <translation>手动发送：{frame}。按其他程序的指令处理。</translation>
    </message>
    <message>
        <source>Log begun: {name}</source>
        <translation>开始写日志：{name}</translation>
    </message>
    <message>
        <source>Log written: {name}, {frames} frames, {size} MB</source>
        <translation>日志已写入：{name}，{frames} 帧，{size} MB</translation>
    </message>
    <message>
        <source>The log has ended: {reason}</source>
        <translation>日志已中断：{reason}</translation>
    </message>
    <message>
        <source>What just happened is saved: {name}</source>
        <translation>已保存刚才发生的事：{name}</translation>
    </message>
    <message>
        <source>What just happened could not be saved: {reason}</source>
        <translation>无法保存刚才发生的事：{reason}</translation>
    </message>
    <message>
        <source>{device} jogs {axes} (joints)</source>
        <translation>{device} 点动 {axes}（关节）</translation>
    </message>
    <message>
        <source>{device} jogs {axes} (base frame)</source>
        <translation>{device} 点动 {axes}（基坐标系）</translation>
    </message>
    <message>
        <source>{device} jogs {axes} (tool frame)</source>
        <translation>{device} 点动 {axes}（工具坐标系）</translation>
    </message>
    <message>
        <source>Told the arm to leave the other program&apos;s mode and to hold where it stands.</source>
        <translation>已通知机械臂退出另一程序的模式，并保持在当前位置。</translation>
    </message>
    <message>
        <source>Mounting sent: {mounting}. The arm does not report it back.</source>
        <translation>已发送安装方式：{mounting}。机械臂不会回报。</translation>
    </message>
    <message>
        <source>Last time this arm (node {node}) was a {before}: that is used instead of {chosen}, which was only the default.</source>
        <translation>此机械臂（节点 {node}）上次为 {before}：已采用该型号，代替默认给出的 {chosen}。</translation>
    </message>
    <message>
        <source>Connected as a {chosen}, but last time this arm (node {node}) was a {before}. If it is one, connect it as that.</source>
        <translation>当前按 {chosen} 连接，但此机械臂（节点 {node}）上次为 {before}。如属实，请按该型号重新连接。</translation>
    </message>
    <message>
        <source>armui cannot tell whether another copy runs on this computer: {path} cannot be used ({text}). Do not start the program twice for one arm.</source>
        <translation>无法得知本机是否还有另一个 armui 在运行：{path} 不可用（{text}）。请勿对同一机械臂启动两个程序。</translation>
    </message>
    <message>
        <source>The change is in effect, but not saved. {reason}</source>
        <translation>更改已生效，但未能保存。{reason}</translation>
    </message>
    <message>
        <source>A disk or network folder has spent more than 10 s on one file. Other files no longer wait for it. If it does not finish, check the cable or network. (Under way: {count})</source>
        <translation>有磁盘或网络文件夹处理一个文件已超过 10 s，其他文件不再等它。若一直不结束，请检查线缆或网络。（进行中：{count}）</translation>
    </message>
    <message>
        <source>“{question}” was withdrawn. {reason}</source>
        <translation>“{question}”已撤回。{reason}</translation>
    </message>
    <message>
        <source>A part of the program has failed ({part}). The emergency stop still works; every motion of this program is ended. Start the program again.</source>
        <translation>程序的一部分出错（{part}）。急停仍有效；本程序的所有运动均已结束。请重新启动程序。</translation>
    </message>
    <message>
        <source>Sent J{joint} to its mark at {target}°</source>
        <translation>已发送：J{joint} 到刻线 {target}°</translation>
    </message>
    <message>
        <source>Reference check finished: all joints stand where they report.</source>
        <translation>零位基准检查完成：全部关节都在上报的位置。</translation>
    </message>
    <message>
        <source>Reference pose kept for this arm</source>
        <translation>已为这台机械臂保存基准位姿</translation>
    </message>
    <message>
        <source>Of an earlier day: the reference of joint {joints} is in doubt, and was not checked since.</source>
        <translation>之前的记录：关节 {joints} 的零位基准存疑，至今尚未检查。</translation>
    </message>
    <message>
        <source>Cell in force: {name}</source>
        <translation>生效的单元：{name}</translation>
    </message>
    <message>
        <source>Reference check begun</source>
        <translation>零位基准检查已开始</translation>
    </message>
    <message>
        <source>The arm is clear of the work area again.</source>
        <translation>机械臂已离开工作区的禁区。</translation>
    </message>
    <message>
        <source>Cell confirmed: {name}</source>
        <translation>单元已确认：{name}</translation>
    </message>
    <message>
        <source>Reference check finished: joint {joints} does not stand where it reports.</source>
        <translation>零位基准检查完成：关节 {joints} 不在上报的位置。</translation>
    </message>
    <message>
        <source>Cell changed: {name}</source>
        <translation>单元已更改：{name}</translation>
    </message>
    <message>
        <source>Cell deleted: {name}</source>
        <translation>单元已删除：{name}</translation>
    </message>
    <message>
        <source>Motions are agreed to for {seconds} s, with the reference of joint {joints} in doubt</source>
        <translation>已同意在关节 {joints} 零位基准存疑时运动，{seconds} s 内有效</translation>
    </message>
    <message>
        <source>Joint {joint} left its place of {place}° uncommanded, enabled, and was reported at {value}°: its reference is in doubt. It may stand elsewhere than it reports from now on.</source>
        <translation>关节 {joint} 在使能且无指令的情况下离开了 {place}°，上报为 {value}°：其零位基准存疑。此后它的实际位置可能与上报不符。</translation>
    </message>
    <message>
        <source>No cell is in force</source>
        <translation>没有生效的单元</translation>
    </message>
</context>
<context>
    <name>Observed</name>
    <message>
        <source>Control mode: {before} → {mode}</source>
        <translation>控制模式：{before} → {mode}</translation>
    </message>
    <message>
        <source>Motion mode: {before} → {mode}</source>
        <translation>运动模式：{before} → {mode}</translation>
    </message>
    <message>
        <source>Arm status: {status}</source>
        <translation>机械臂状态：{status}</translation>
    </message>
    <message>
        <source>Drag teaching: {before} → {state}</source>
        <translation>拖动示教：{before} → {state}</translation>
    </message>
    <message>
        <source>Target not reached</source>
        <translation>未到达指定点</translation>
    </message>
    <message>
        <source>Motors enabled: {joints}</source>
        <translation>电机已使能：{joints}</translation>
    </message>
    <message>
        <source>Motors disabled: {joints}</source>
        <translation>电机已失能：{joints}</translation>
    </message>
    <message>
        <source>J{joint} beyond its angle limit</source>
        <translation>J{joint} 超出角度限位</translation>
    </message>
    <message>
        <source>Gripper: {fault}</source>
        <translation>夹爪：{fault}</translation>
    </message>
    <message>
        <source>J{joint}: the limits stored in the arm cannot be true</source>
        <translation>J{joint}：机械臂中存储的限位不可信</translation>
    </message>
    <message>
        <source>Another host sends {id}</source>
        <translation>其他程序发送 {id}</translation>
    </message>
    <message>
        <source>Frames not understood: {kind} (last {id})</source>
        <translation>无法识别的报文：{kind}（最近 {id}）</translation>
    </message>
    <message>
        <source>Fewer status frames from the arm: {share} % less than before</source>
        <translation>机械臂状态报文变少：比之前少 {share} %</translation>
    </message>
    <message>
        <source>Sent the point of row {row}</source>
        <translation>已发送第 {row} 行的点</translation>
    </message>
    <message>
        <source>Target reached, as the arm reports</source>
        <translation>机械臂反馈：已达指定点</translation>
    </message>
    <message>
        <source>Did not reach its end: {end}</source>
        <translation>未运动到终点：{end}</translation>
    </message>
    <message>
        <source>Release sent</source>
        <translation>已发送解除急停</translation>
    </message>
    <message>
        <source>The gripper&apos;s reading jumps from {before} to {after} {unit} within {within_ms} ms, faster than any gripper: its angle has wrapped, its zero was set, or a second arm answers</source>
        <translation>夹爪读数在 {within_ms} ms 内从 {before} 跳到 {after} {unit}，任何夹爪都没有这么快：角度回绕、设置了零位，或有第二台机械臂在应答</translation>
    </message>
    <message>
        <source>J{joint} {item}: {word}</source>
        <translation>J{joint} {item}：{word}</translation>
    </message>
    <message>
        <source>Answered with 0x476 (setting {index})</source>
        <translation>已用 0x476 应答（设置 {index}）</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>The events cannot be written to the disk; the newest are kept in memory. {text}</source>
        <translation>事件无法写入磁盘，最新的保留在内存中。{text}</translation>
    </message>
    <message>
        <source>Emergency stop sent</source>
        <translation>已发送急停</translation>
    </message>
    <message>
        <source>Motors: enable sent</source>
        <translation>已发送电机使能</translation>
    </message>
    <message>
        <source>Motors: disable sent</source>
        <translation>已发送电机失能</translation>
    </message>
    <message>
        <source>Trajectory or drag teaching command sent</source>
        <translation>已发送轨迹或拖动示教指令</translation>
    </message>
    <message>
        <source>{message} begin</source>
        <translation>开始发送{message}</translation>
    </message>
    <message>
        <source>Episode {number}: “{task}”</source>
        <translation>片段 {number}：“{task}”</translation>
    </message>
    <message>
        <source>Episode {number}, discarded: “{task}”</source>
        <translation>片段 {number}（已弃用）：“{task}”</translation>
    </message>
    <message>
        <source>Unknown event: {code}</source>
        <translation>未知事件：{code}</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Set the end load</source>
        <translation>设置末端负载</translation>
    </message>
    <message>
        <source>Switch the end&apos;s motion feedback</source>
        <translation>开关末端速度与加速度反馈</translation>
    </message>
    <message>
        <source>Move the gripper</source>
        <translation>夹爪运动</translation>
    </message>
    <message>
        <source>Enable the gripper</source>
        <translation>夹爪使能</translation>
    </message>
    <message>
        <source>Disable the gripper</source>
        <translation>夹爪失能</translation>
    </message>
    <message>
        <source>Clear the gripper&apos;s error</source>
        <translation>清除夹爪错误</translation>
    </message>
    <message>
        <source>Set the gripper&apos;s zero</source>
        <translation>设置夹爪零点</translation>
    </message>
    <message>
        <source>Clear errors of the drivers</source>
        <translation>清除驱动器错误</translation>
    </message>
    <message>
        <source>Set the lamps of a joint</source>
        <translation>设置关节灯光</translation>
    </message>
    <message>
        <source>Set linkage role and ID offsets</source>
        <translation>设置联动角色与 ID 偏移</translation>
    </message>
    <message>
        <source>Enable motors</source>
        <translation>使能电机</translation>
    </message>
    <message>
        <source>Disable motors</source>
        <translation>失能电机</translation>
    </message>
    <message>
        <source>Set the mounting</source>
        <translation>设置安装方式</translation>
    </message>
    <message>
        <source>Command drag teaching</source>
        <translation>拖动示教命令</translation>
    </message>
    <message>
        <source>Set zeros</source>
        <translation>设置零点</translation>
    </message>
    <message>
        <source>Move the tool to a pose</source>
        <translation>末端运动到位姿</translation>
    </message>
    <message>
        <source>Move the tool by a step</source>
        <translation>末端步进</translation>
    </message>
    <message>
        <source>Move the tool along an arc</source>
        <translation>末端沿圆弧运动</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Move a joint by a step</source>
        <translation>关节步进</translation>
    </message>
    <message>
        <source>Move the joints to angles</source>
        <translation>关节运动到角度</translation>
    </message>
    <message>
        <source>Move to the factory zero angles</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Bring the arm inside its limits</source>
        <translation>使机械臂回到限位内</translation>
    </message>
    <message>
        <source>Pause, continue, clear or end a planned motion</source>
        <translation>暂停、继续、清除或终止规划运动</translation>
    </message>
    <message>
        <source>Read parameters</source>
        <translation>读取参数</translation>
    </message>
    <message>
        <source>Set parameters</source>
        <translation>设置参数</translation>
    </message>
    <message>
        <source>Restore the factory limits of the end</source>
        <translation>末端限制恢复出厂值</translation>
    </message>
    <message>
        <source>Restore the factory limits of the joints</source>
        <translation>关节限制恢复出厂值</translation>
    </message>
    <message>
        <source>Inspect the joints</source>
        <translation>关节巡检</translation>
    </message>
    <message>
        <source>Run a trajectory</source>
        <translation>执行轨迹</translation>
    </message>
    <message>
        <source>Pause the run</source>
        <translation>暂停执行</translation>
    </message>
    <message>
        <source>Continue the run</source>
        <translation>继续执行</translation>
    </message>
    <message>
        <source>Record the arm&apos;s motion</source>
        <translation>录制机械臂运动</translation>
    </message>
    <message>
        <source>Replay a recording</source>
        <translation>回放录制</translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation>暂停回放</translation>
    </message>
    <message>
        <source>Continue the replay</source>
        <translation>继续回放</translation>
    </message>
    <message>
        <source>Begin an episode</source>
        <translation>开始片段</translation>
    </message>
    <message>
        <source>End the episode</source>
        <translation>结束片段</translation>
    </message>
    <message>
        <source>Discard the last episode</source>
        <translation>弃用最后一个片段</translation>
    </message>
    <message>
        <source>Make or import a cell</source>
        <translation>新建或导入单元</translation>
    </message>
    <message>
        <source>Check the reference</source>
        <translation>检查零位基准</translation>
    </message>
    <message>
        <source>Confirm the cell</source>
        <translation>确认单元</translation>
    </message>
    <message>
        <source>Choose the cell</source>
        <translation>选择单元</translation>
    </message>
    <message>
        <source>Rename the cell</source>
        <translation>给单元改名</translation>
    </message>
    <message>
        <source>Release the emergency stop</source>
        <translation>解除急停</translation>
    </message>
    <message>
        <source>Teach the reference pose</source>
        <translation>示教基准位姿</translation>
    </message>
    <message>
        <source>Drive a joint to its mark</source>
        <translation>将关节驱动到刻线</translation>
    </message>
    <message>
        <source>Finish the reference check</source>
        <translation>完成零位基准检查</translation>
    </message>
    <message>
        <source>Delete the cell</source>
        <translation>删除单元</translation>
    </message>
    <message>
        <source>Change the cell</source>
        <translation>更改单元</translation>
    </message>
    <message>
        <source>Say what the gripper holds</source>
        <translation>标记夹爪夹持的工件</translation>
    </message>
    <message>
        <source>Set the speed</source>
        <translation>设置速度</translation>
    </message>
    <message>
        <source>Move with the reference in doubt</source>
        <translation>零位基准存疑时运动</translation>
    </message>
</context>
<context>
    <name>OtherArmLine</name>
    <message>
        <source>This was taught on another arm: {taught}. Chosen is {arm}.</source>
        <translation>此轨迹在另一种机械臂上示教：{taught}。当前选择的是 {arm}。</translation>
    </message>
    <message>
        <source>Turns the joints of every point by {degrees}, so that the arm comes to the same place. Poses stay: they count from the base. It can be undone.</source>
        <translation>每个点的关节转动 {degrees}，使机械臂到达同一位置。位姿保持不变：它们以基座计。可以撤销。</translation>
    </message>
    <message>
        <source>Convert zeros</source>
        <translation>换算零点</translation>
    </message>
</context>
<context>
    <name>OtherMode</name>
    <message>
        <source>MIT</source>
        <translation>MIT（力位混合）</translation>
    </message>
    <message>
        <source>CPV</source>
        <translation>CPV（速度位置）</translation>
    </message>
    <message>
        <source>high-follow</source>
        <translation>高跟随</translation>
    </message>
</context>
<context>
    <name>OwnHome</name>
    <message>
        <source>Park position</source>
        <translation>停放位</translation>
    </message>
    <message>
        <source>Moves the joints to {angles}.</source>
        <translation>各关节运动到 {angles}。</translation>
    </message>
    <message>
        <source>Sets the park position of this arm; nothing moves.</source>
        <translation>为此机械臂设定停放位，不运动。</translation>
    </message>
    <message>
        <source>Set park position</source>
        <translation>设定停放位</translation>
    </message>
    <message>
        <source>Set to the measured angles</source>
        <translation>设为当前测得的角度</translation>
    </message>
    <message>
        <source>Set to the targets in the fields</source>
        <translation>设为输入框中的目标</translation>
    </message>
    <message>
        <source>This arm reports no number of its own: another one without a number at this adapter would be taken for it.</source>
        <translation>此机械臂不报自己的编号：同一适配器上另一台不报编号的机械臂会被当作它。</translation>
    </message>
</context>
<context>
    <name>PageActions</name>
    <message>
        <source>Open a trajectory of the library first.</source>
        <translation>请先在轨迹库中打开一条轨迹。</translation>
    </message>
    <message>
        <source>It is in its own window.</source>
        <translation>已在独立窗口中。</translation>
    </message>
    <message>
        <source>It is not in its own window.</source>
        <translation>不在独立窗口中。</translation>
    </message>
    <message>
        <source>The drawer is folded away.</source>
        <translation>抽屉已收起。</translation>
    </message>
</context>
<context>
    <name>PageBar</name>
    <message>
        <source>the panel</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Back to {where} (Esc)</source>
        <translation>返回{where} (Esc)</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>独立窗口</translation>
    </message>
    <message>
        <source>Moves this page into its own window, for a second screen.</source>
        <translation>把本页移到独立窗口，例如放到第二块屏幕上。</translation>
    </message>
</context>
<context>
    <name>PageWindow</name>
    <message>
        <source>Put back</source>
        <translation>放回</translation>
    </message>
    <message>
        <source>Puts this page back beside the 3D picture.</source>
        <translation>把本页放回 3D 画面旁边。</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Max. angle</source>
        <translation>最大角度</translation>
    </message>
    <message>
        <source>Min. angle</source>
        <translation>最小角度</translation>
    </message>
    <message>
        <source>Max. speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Max. acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Max. linear speed of the end</source>
        <translation>末端最大线速度</translation>
    </message>
    <message>
        <source>Max. angular speed of the end</source>
        <translation>末端最大角速度</translation>
    </message>
    <message>
        <source>Max. linear acceleration of the end</source>
        <translation>末端最大线加速度</translation>
    </message>
    <message>
        <source>Max. angular acceleration of the end</source>
        <translation>末端最大角加速度</translation>
    </message>
    <message>
        <source>Collision level</source>
        <translation>碰撞等级</translation>
    </message>
    <message>
        <source>Teaching range</source>
        <translation>示教范围</translation>
    </message>
    <message>
        <source>Gripper stroke limit</source>
        <translation>夹爪行程</translation>
    </message>
    <message>
        <source>Teaching friction</source>
        <translation>示教摩擦力</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>读取中…</translation>
    </message>
    <message>
        <source>corrupt</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>saving…</source>
        <translation>保存中…</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>无效</translation>
    </message>
    <message>
        <source>Not read from the arm.</source>
        <translation>未从机械臂读取。</translation>
    </message>
    <message>
        <source>Being read from the arm.</source>
        <translation>正在从机械臂读取。</translation>
    </message>
    <message>
        <source>The value stored in the arm cannot be right: its memory is corrupt (0xFFFF). Enter a value and save it.</source>
        <translation>机械臂中保存的值不可能成立：其存储已损坏 (0xFFFF)。请输入数值并保存。</translation>
    </message>
    <message>
        <source>Changed and not saved; the arm holds {held}.</source>
        <translation>已修改，未保存；机械臂中为 {held}。</translation>
    </message>
    <message>
        <source>Sent to the arm; its answer is awaited.</source>
        <translation>已发送，等待机械臂应答。</translation>
    </message>
    <message>
        <source>Saved: the arm holds this value.</source>
        <translation>已保存：机械臂中为此值。</translation>
    </message>
    <message>
        <source>= the same</source>
        <translation>= 相同</translation>
    </message>
    <message>
        <source>≠ differs</source>
        <translation>≠ 不同</translation>
    </message>
    <message>
        <source>only in the file</source>
        <translation>仅文件中有</translation>
    </message>
    <message>
        <source>only in the arm</source>
        <translation>仅机械臂中有</translation>
    </message>
    <message>
        <source>not read from the arm</source>
        <translation>未从机械臂读到</translation>
    </message>
    <message>
        <source>Range: {minimum} to {maximum}</source>
        <translation>可设范围：{minimum} 至 {maximum}</translation>
    </message>
    <message>
        <source>Drag assistance</source>
        <translation>拖动助力</translation>
    </message>
    <message>
        <source>factory {bound}</source>
        <translation>出厂 {bound}</translation>
    </message>
    <message>
        <source>{name}: {value} goes beyond the factory&apos;s {bound}.</source>
        <translation>{name}：{value} 超出出厂值 {bound}。</translation>
    </message>
    <message>
        <source>The arm may then be driven against its mechanical stops or beyond what its motors are made for, and no check here prevents it. Save this only if you know that this arm can do it.</source>
        <translation>之后机械臂可能撞到机械限位或超出电机的设计能力，本程序的检查也不再拦住它。只有确知这台机械臂做得到时才保存。</translation>
    </message>
</context>
<context>
    <name>ParameterButtons</name>
    <message>
        <source>Read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Initialise</source>
        <translation>初始化</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>ParameterPanel</name>
    <message>
        <source>Saved; reading back gave the same values.</source>
        <translation>已保存：已从机械臂回读，数值一致。</translation>
    </message>
    <message>
        <source>Saved. The arm stores coarser steps; it holds the nearest: {values}.</source>
        <translation>已保存。机械臂的分辨率较粗，已取最接近的值：{values}。</translation>
    </message>
    <message>
        <source>was {held}</source>
        <translation>原值 {held}</translation>
    </message>
    <message>
        <source>Nothing has been changed.</source>
        <translation>没有修改任何值。</translation>
    </message>
    <message>
        <source>Save or cancel your changes first.</source>
        <translation>请先保存或取消修改。</translation>
    </message>
    <message>
        <source>The arm is being asked; wait for its answer.</source>
        <translation>正在与机械臂通信，请等待应答。</translation>
    </message>
    <message>
        <source>Sends what was changed, reads it back and compares.</source>
        <translation>发送修改过的值，回读并比较。</translation>
    </message>
    <message>
        <source>Backup…</source>
        <translation>参数备份…</translation>
    </message>
    <message>
        <source>All parameters of the arm: save them to a file, compare, restore.</source>
        <translation>机械臂的全部参数：保存到文件、比较、恢复。</translation>
    </message>
    <message>
        <source>Reads the values from the arm.</source>
        <translation>从机械臂读取数值。</translation>
    </message>
    <message>
        <source>Lets you change the values; nothing is sent.</source>
        <translation>可修改数值；不发送任何指令。</translation>
    </message>
    <message>
        <source>Shows what the arm holds again.</source>
        <translation>重新显示机械臂中的值。</translation>
    </message>
    <message>
        <source>{names}: {reason}</source>
        <translation>{names}：{reason}</translation>
    </message>
</context>
<context>
    <name>PictureExport</name>
    <message>
        <source>Picture copied</source>
        <translation>画面已复制</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存画面</translation>
    </message>
    <message>
        <source>The present picture is not drawn yet. Wait a moment, then try again.</source>
        <translation>当前画面尚未绘制完成，请稍候再试。</translation>
    </message>
</context>
<context>
    <name>Place</name>
    <message>
        <source>In every window</source>
        <translation>所有窗口</translation>
    </message>
    <message>
        <source>Main window</source>
        <translation>主窗口</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D 视图</translation>
    </message>
    <message>
        <source>Jogging by keys</source>
        <translation>键盘点动</translation>
    </message>
    <message>
        <source>Panels with parameters</source>
        <translation>参数面板</translation>
    </message>
    <message>
        <source>Trajectory editor</source>
        <translation>轨迹编辑器</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Drawer</source>
        <translation>抽屉</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
</context>
<context>
    <name>PlotBar</name>
    <message>
        <source>Target vs measured</source>
        <translation>目标与测量</translation>
    </message>
    <message>
        <source>Temperatures and currents</source>
        <translation>温度与电流</translation>
    </message>
    <message>
        <source>Why it stopped</source>
        <translation>停止原因</translation>
    </message>
    <message>
        <source>Tool pose</source>
        <translation>末端位姿</translation>
    </message>
    <message>
        <source>Bus health</source>
        <translation>总线状况</translation>
    </message>
    <message>
        <source>Custom layout</source>
        <translation>自定义布局</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Sets of plots, ready made</source>
        <translation>预设的一组曲线图</translation>
    </message>
    <message>
        <source>The time span shown; the mouse wheel changes it, too</source>
        <translation>显示的时间长度；也可用鼠标滚轮改变</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>显示时长</translation>
    </message>
    <message>
        <source>Undo zoom</source>
        <translation>撤销缩放</translation>
    </message>
    <message>
        <source>Drag a box in a plot to zoom in. Back: Ctrl+Z</source>
        <translation>在图中拖出方框即可放大。返回之前的显示：Ctrl+Z</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>游标</translation>
    </message>
    <message>
        <source>Two vertical lines to drag; the table below shows the values there</source>
        <translation>两条可拖动的竖线；下方表格显示该处的数值</translation>
    </message>
    <message>
        <source>Values as CSV…</source>
        <translation>数值存为 CSV…</translation>
    </message>
    <message>
        <source>Picture as PNG…</source>
        <translation>图片存为 PNG…</translation>
    </message>
    <message>
        <source>Picture as SVG…</source>
        <translation>图片存为 SVG…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Copy values at the cursors</source>
        <translation>复制游标处的数值</translation>
    </message>
    <message>
        <source>{count} min</source>
        <translation>{count} 分钟</translation>
    </message>
    <message>
        <source>{count} s</source>
        <translation>{count} 秒</translation>
    </message>
</context>
<context>
    <name>PlotExport</name>
    <message>
        <source>Save the plots</source>
        <translation>保存曲线</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
</context>
<context>
    <name>PlotPage</name>
    <message>
        <source>The layout of the plots could not be saved: {text}</source>
        <translation>无法保存曲线布局：{text}</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
</context>
<context>
    <name>PlotsArea</name>
    <message>
        <source>Remove curve</source>
        <translation>移除曲线</translation>
    </message>
    <message>
        <source>Move to its own plot</source>
        <translation>移到单独的图</translation>
    </message>
    <message>
        <source>Fit the height</source>
        <translation>适应高度</translation>
    </message>
    <message>
        <source>Undo zoom</source>
        <translation>撤销缩放</translation>
    </message>
    <message>
        <source>Remove plot</source>
        <translation>移除此图</translation>
    </message>
    <message>
        <source>There are {count} plots already: remove one first.</source>
        <translation>已有 {count} 张图：请先移除一张。</translation>
    </message>
    <message>
        <source>A plot takes {count} curves at most, so that they can be told apart.</source>
        <translation>为便于区分，一张图最多 {count} 条曲线。</translation>
    </message>
</context>
<context>
    <name>PointEdits</name>
    <message>
        <source>Replace with current pose</source>
        <translation>替换为当前位姿</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>插入</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Convert</source>
        <translation>转换</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>用户坐标系</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Convert zeros</source>
        <translation>换算零点</translation>
    </message>
</context>
<context>
    <name>PointFigure</name>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>停留时间</translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation>夹爪开度</translation>
    </message>
    <message>
        <source>Gripper torque</source>
        <translation>夹爪力矩</translation>
    </message>
    <message>
        <source>Gripper angle</source>
        <translation>夹爪角度</translation>
    </message>
    <message>
        <source>Gripper speed</source>
        <translation>夹爪速度</translation>
    </message>
    <message>
        <source>Light, joint</source>
        <translation>灯光关节</translation>
    </message>
    <message>
        <source>Light, lamp</source>
        <translation>灯光灯号</translation>
    </message>
    <message>
        <source>Light, R</source>
        <translation>灯光 R</translation>
    </message>
    <message>
        <source>Light, G</source>
        <translation>灯光 G</translation>
    </message>
    <message>
        <source>Light, B</source>
        <translation>灯光 B</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Middle pose</source>
        <translation>中间位姿</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Time since the row before</source>
        <translation>距上一行的时间</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Arm it was taught on</source>
        <translation>示教所用机械臂</translation>
    </message>
</context>
<context>
    <name>PointTarget</name>
    <message>
        <source>Drag in the picture</source>
        <translation>在画面中拖动</translation>
    </message>
</context>
<context>
    <name>PointsModel</name>
    <message>
        <source>J{joint} all</source>
        <translation>J{joint} 全部</translation>
    </message>
    <message>
        <source>holds {name}</source>
        <translation>夹着 {name}</translation>
    </message>
    <message>
        <source>holds nothing</source>
        <translation>不夹工件</translation>
    </message>
    <message>
        <source>Its place counts from the user frame “{name}” of the cell.</source>
        <translation>其位置以单元的用户坐标系“{name}”为基准。</translation>
    </message>
    <message>
        <source>Poses in the table are those of the flange: no tool is in force.</source>
        <translation>表中的位姿是法兰的位姿：没有生效的工具。</translation>
    </message>
    <message>
        <source>Poses in the table are of the tool centre point of {tool}. A point keeps where the flange is: another tool changes these figures, not where the arm goes.</source>
        <translation>表中的位姿是{tool}的工具中心点的位姿。点保存的是法兰的位姿：更换工具只改变这里的数值，不改变机械臂的去处。</translation>
    </message>
    <message>
        <source>the tool “{name}”</source>
        <translation>工具“{name}”</translation>
    </message>
    <message>
        <source>the tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>flange</source>
        <translation>法兰</translation>
    </message>
    <message>
        <source>Motion
({point})</source>
        <translation>运动
（{point}）</translation>
    </message>
    <message>
        <source>Middle
pose</source>
        <translation>中间
位姿</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>停留</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>灯光</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
</context>
<context>
    <name>PoseExtras</name>
    <message>
        <source>Arc by three poses</source>
        <translation>三点圆弧</translation>
    </message>
    <message>
        <source>Tool centre point</source>
        <translation>工具中心点</translation>
    </message>
</context>
<context>
    <name>PoseRow</name>
    <message>
        <source>Moves along {axis} while it is held; let go to stop.</source>
        <translation>按住时沿 {axis} 运动，松开即停止。</translation>
    </message>
    <message>
        <source>Moves along {axis} by {step} at once.</source>
        <translation>立即沿 {axis} 移动 {step}。</translation>
    </message>
    <message>
        <source>{axis} minus</source>
        <translation>{axis} 减</translation>
    </message>
    <message>
        <source>{axis} plus</source>
        <translation>{axis} 加</translation>
    </message>
    <message>
        <source>Target {axis}</source>
        <translation>目标 {axis}</translation>
    </message>
    <message>
        <source>Not sent before you press MOVE P or MOVE L.</source>
        <translation>按下 MOVE P 或 MOVE L 之前不会发送。</translation>
    </message>
    <message>
        <source>Measured by the arm</source>
        <translation>机械臂测量值</translation>
    </message>
</context>
<context>
    <name>PreviewBar</name>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Moves the ghost arm only; the real arm stays where it is.</source>
        <translation>只移动虚影机械臂，真实机械臂不动。</translation>
    </message>
    <message>
        <source>Time of the preview</source>
        <translation>预览时间</translation>
    </message>
    <message>
        <source>Moves the ghost arm through the motion.</source>
        <translation>拖动以查看虚影机械臂的运动过程。</translation>
    </message>
    <message>
        <source>Close preview</source>
        <translation>关闭预览</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
</context>
<context>
    <name>ProblemReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>报告问题</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Add the last minutes of the bus</source>
        <translation>加入总线最近几分钟的报文</translation>
    </message>
    <message>
        <source>These files are put into one zip file on this computer: look at each before. Nothing is sent anywhere; you give the file to whoever helps. The folder of your user is called ~ in it; serial numbers of adapters stay.</source>
        <translation>以下文件将存为本机上的一个 zip 文件，保存前可逐个查看。不会发送到任何地方；由您自己交给协助者。其中您的用户文件夹写作 ~，适配器的序列号保留。</translation>
    </message>
    <message>
        <source>Files of the report</source>
        <translation>报告中的文件</translation>
    </message>
    <message>
        <source>The file that is chosen</source>
        <translation>所选文件</translation>
    </message>
    <message>
        <source>Looking at this computer, logs and settings…</source>
        <translation>正在检查本机、日志和设置…</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Saving {path}…</source>
        <translation>正在保存 {path}…</translation>
    </message>
    <message>
        <source>Saved: {path}</source>
        <translation>已保存：{path}</translation>
    </message>
    <message>
        <source>The disk does not answer. Save the report in another folder.</source>
        <translation>磁盘没有响应。请把报告保存到其他文件夹。</translation>
    </message>
    <message>
        <source>The report is being collected.</source>
        <translation>正在收集报告。</translation>
    </message>
    <message>
        <source>The frames are being written down.</source>
        <translation>正在写出报文。</translation>
    </message>
    <message>
        <source>The report is being saved.</source>
        <translation>正在保存报告。</translation>
    </message>
    <message>
        <source>There is nothing to save.</source>
        <translation>没有可保存的内容。</translation>
    </message>
    <message>
        <source>Nothing was heard on a bus.</source>
        <translation>总线上没有收到过报文。</translation>
    </message>
    <message>
        <source>… {size} are not shown here …</source>
        <translation>…… 此处省略 {size} ……</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Up</source>
        <translation>↑</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>↓</translation>
    </message>
</context>
<context>
    <name>Quantity</name>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>End X</source>
        <translation>末端 X</translation>
    </message>
    <message>
        <source>End Y</source>
        <translation>末端 Y</translation>
    </message>
    <message>
        <source>End Z</source>
        <translation>末端 Z</translation>
    </message>
    <message>
        <source>End RX</source>
        <translation>末端 RX</translation>
    </message>
    <message>
        <source>End RY</source>
        <translation>末端 RY</translation>
    </message>
    <message>
        <source>End RZ</source>
        <translation>末端 RZ</translation>
    </message>
    <message>
        <source>Tool centre point X</source>
        <translation>工具中心点 X</translation>
    </message>
    <message>
        <source>Tool centre point Y</source>
        <translation>工具中心点 Y</translation>
    </message>
    <message>
        <source>Tool centre point Z</source>
        <translation>工具中心点 Z</translation>
    </message>
    <message>
        <source>Tool centre point RX</source>
        <translation>工具中心点 RX</translation>
    </message>
    <message>
        <source>Tool centre point RY</source>
        <translation>工具中心点 RY</translation>
    </message>
    <message>
        <source>Tool centre point RZ</source>
        <translation>工具中心点 RZ</translation>
    </message>
    <message>
        <source>Speed percentage</source>
        <translation>速度百分比</translation>
    </message>
    <message>
        <source>Trajectory point</source>
        <translation>轨迹点</translation>
    </message>
    <message>
        <source>Joints beyond limit</source>
        <translation>超限关节</translation>
    </message>
    <message>
        <source>Joints without communication</source>
        <translation>通信异常关节</translation>
    </message>
    <message>
        <source>Control mode</source>
        <translation>控制模式</translation>
    </message>
    <message>
        <source>Arm status</source>
        <translation>机械臂状态</translation>
    </message>
    <message>
        <source>Move mode</source>
        <translation>运动模式</translation>
    </message>
    <message>
        <source>Teaching state</source>
        <translation>示教状态</translation>
    </message>
    <message>
        <source>Target not reached</source>
        <translation>未达指定点</translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation>夹爪开度</translation>
    </message>
    <message>
        <source>Gripper torque</source>
        <translation>夹爪力矩</translation>
    </message>
    <message>
        <source>Gripper angle</source>
        <translation>夹爪角度</translation>
    </message>
    <message>
        <source>Gripper speed</source>
        <translation>夹爪速度</translation>
    </message>
    <message>
        <source>Gripper faults</source>
        <translation>夹爪故障</translation>
    </message>
    <message>
        <source>Gripper enabled</source>
        <translation>夹爪已使能</translation>
    </message>
    <message>
        <source>motor speed</source>
        <translation>电机转速</translation>
    </message>
    <message>
        <source>motor current</source>
        <translation>电机电流</translation>
    </message>
    <message>
        <source>motor position</source>
        <translation>电机位置</translation>
    </message>
    <message>
        <source>supply voltage</source>
        <translation>电源电压</translation>
    </message>
    <message>
        <source>driver temperature</source>
        <translation>驱动器温度</translation>
    </message>
    <message>
        <source>motor temperature</source>
        <translation>电机温度</translation>
    </message>
    <message>
        <source>supply current</source>
        <translation>母线电流</translation>
    </message>
    <message>
        <source>driver faults</source>
        <translation>驱动器故障</translation>
    </message>
    <message>
        <source>enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>part in linear speed</source>
        <translation>末端线速度分量</translation>
    </message>
    <message>
        <source>part in angular speed</source>
        <translation>末端角速度分量</translation>
    </message>
    <message>
        <source>part in linear acceleration</source>
        <translation>末端线加速度分量</translation>
    </message>
    <message>
        <source>part in angular acceleration</source>
        <translation>末端角加速度分量</translation>
    </message>
    <message>
        <source>MIT position</source>
        <translation>MIT 位置</translation>
    </message>
    <message>
        <source>MIT speed</source>
        <translation>MIT 速度</translation>
    </message>
    <message>
        <source>MIT torque</source>
        <translation>MIT 扭矩</translation>
    </message>
    <message>
        <source>MIT kp</source>
        <translation>MIT kp</translation>
    </message>
    <message>
        <source>MIT kd</source>
        <translation>MIT kd</translation>
    </message>
    <message>
        <source>Frames on the bus</source>
        <translation>总线帧数</translation>
    </message>
    <message>
        <source>Bus load, without stuff bits</source>
        <translation>总线负载（不含填充位）</translation>
    </message>
    <message>
        <source>Error frames</source>
        <translation>错误帧</translation>
    </message>
    <message>
        <source>{name}, our command</source>
        <translation>{name}（本程序指令）</translation>
    </message>
    <message>
        <source>{name}, other host&apos;s command</source>
        <translation>{name}（其他程序指令）</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>our command</source>
        <translation>本程序指令</translation>
    </message>
    <message>
        <source>other host&apos;s command</source>
        <translation>其他程序指令</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Commanded by this program</source>
        <translation>本程序的指令</translation>
    </message>
    <message>
        <source>Commanded by other hosts</source>
        <translation>其他程序的指令</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>voltage too low</source>
        <translation>电压过低</translation>
    </message>
    <message>
        <source>motor too hot</source>
        <translation>电机过温</translation>
    </message>
    <message>
        <source>overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>driver too hot</source>
        <translation>驱动器过温</translation>
    </message>
    <message>
        <source>sensor fault</source>
        <translation>传感器异常</translation>
    </message>
    <message>
        <source>driver error</source>
        <translation>驱动器错误</translation>
    </message>
    <message>
        <source>collision protection</source>
        <translation>碰撞保护</translation>
    </message>
    <message>
        <source>stall protection</source>
        <translation>堵转保护</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
</context>
<context>
    <name>QuantityList</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation>可绘制的量</translation>
    </message>
    <message>
        <source>Drag into a plot, or double-click to add to the chosen one</source>
        <translation>拖入图中，或双击加入选中的图</translation>
    </message>
</context>
<context>
    <name>Reached</name>
    <message>
        <source>Target left again</source>
        <translation>已离开指定点</translation>
    </message>
    <message>
        <source>Target reached</source>
        <translation>已达指定点</translation>
    </message>
    <message>
        <source>Target not reached</source>
        <translation>未达指定点</translation>
    </message>
</context>
<context>
    <name>RecentlyDeleted</name>
    <message>
        <source>Recently deleted…</source>
        <translation>最近删除…</translation>
    </message>
</context>
<context>
    <name>RecordedCurves</name>
    <message>
        <source>What is recorded appears here</source>
        <translation>录制的曲线显示在此处</translation>
    </message>
    <message>
        <source>Recorded angles of the joints</source>
        <translation>录制的关节角度</translation>
    </message>
    <message>
        <source>Drag the handles: what lies between them is kept</source>
        <translation>拖动两端的手柄：保留其间的部分</translation>
    </message>
</context>
<context>
    <name>RecordingCard</name>
    <message>
        <source>Log to the disk</source>
        <translation>日志写入磁盘</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>New file at</source>
        <translation>分卷大小</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Begin episode</source>
        <translation>开始片段</translation>
    </message>
    <message>
        <source>Marks the beginning of an episode, for a dataset. F6 does it anywhere.</source>
        <translation>标记数据集片段的开始。在任何地方按 F6 也可以。</translation>
    </message>
    <message>
        <source>End episode</source>
        <translation>结束片段</translation>
    </message>
    <message>
        <source>Marks the end of the episode. F6 does it anywhere.</source>
        <translation>标记片段的结束。在任何地方按 F6 也可以。</translation>
    </message>
    <message>
        <source>Discard episode</source>
        <translation>弃用片段</translation>
    </message>
    <message>
        <source>Leaves the last episode out of datasets; nothing of the log is deleted.</source>
        <translation>最后一个片段不进入数据集；日志里什么都不删除。</translation>
    </message>
    <message>
        <source>episode {number} under way, {length}</source>
        <translation>片段 {number} 进行中，{length}</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Task of the episodes</source>
        <translation>片段的任务</translation>
    </message>
    <message>
        <source>What is done in an episode. It is kept for the episodes that follow.</source>
        <translation>片段里做的是什么。之后的片段沿用它。</translation>
    </message>
    <message>
        <source>A file that has grown to this size is followed by another.</source>
        <translation>文件达到此大小后，另起一个新文件。</translation>
    </message>
    <message>
        <source>Not logging</source>
        <translation>未在写日志</translation>
    </message>
    <message>
        <source>The last minutes are kept in memory anyway.</source>
        <translation>最近几分钟始终保留在内存中。</translation>
    </message>
    <message>
        <source>Opening the file…</source>
        <translation>正在打开文件…</translation>
    </message>
    <message>
        <source>{count} episodes</source>
        <translation>{count} 个片段</translation>
    </message>
    <message>
        <source>{length} · {frames} frames · {size} · {rate}/s</source>
        <translation>{length} · {frames} 帧 · {size} · {rate}/秒</translation>
    </message>
    <message>
        <source>{count} lost</source>
        <translation>丢失 {count} 帧</translation>
    </message>
    <message>
        <source>Stop log</source>
        <translation>停止日志</translation>
    </message>
    <message>
        <source>Start log</source>
        <translation>开始日志</translation>
    </message>
    <message>
        <source>Folder of the logs</source>
        <translation>日志的文件夹</translation>
    </message>
</context>
<context>
    <name>RecordingMark</name>
    <message>
        <source>Log being written</source>
        <translation>正在写日志</translation>
    </message>
    <message>
        <source>A log is being written. Click for the logs.</source>
        <translation>正在写日志。单击查看日志。</translation>
    </message>
    <message>
        <source>Log being written, {length}</source>
        <translation>正在写日志，{length}</translation>
    </message>
</context>
<context>
    <name>RecordingPage</name>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Nothing was recorded: the arm reported no angles.</source>
        <translation>未录到数据：机械臂没有反馈关节角度。</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>正在处理…</translation>
    </message>
    <message>
        <source>Nothing is left: correct the marked fields.</source>
        <translation>没有剩余数据：请修正标记的输入框。</translation>
    </message>
    <message>
        <source>Keeps {kept} of {count} samples, {time}, {size}</source>
        <translation>保留 {count} 个采样中的 {kept} 个，{time}，{size}</translation>
    </message>
    <message>
        <source>The path is shown in the 3D view.</source>
        <translation>路径已显示在三维视图中。</translation>
    </message>
    <message>
        <source>Saved as “{name}”.</source>
        <translation>已保存为“{name}”。</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>停止录制</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>开始录制</translation>
    </message>
    <message>
        <source>“{name}” has not been saved. A new recording replaces it.</source>
        <translation>“{name}”尚未保存。开始新的录制会替换它。</translation>
    </message>
    <message>
        <source>Recording: {time}, {count} samples</source>
        <translation>正在录制：{time}，{count} 个采样</translation>
    </message>
    <message>
        <source> ({count} lost)</source>
        <translation>（丢失 {count} 个）</translation>
    </message>
    <message>
        <source>Lead the arm by hand, or move it by anything, while it records.</source>
        <translation>录制期间可拖动机械臂，或以任意方式使其运动。</translation>
    </message>
    <message>
        <source>Trim samples</source>
        <translation>裁剪采样</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>From</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>To</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>How far a joint may be off where samples are left out, in degrees</source>
        <translation>省略采样处关节允许的偏差，单位为度</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>The path in the 3D view, and a ghost arm; the real arm stays where it is</source>
        <translation>在三维视图中显示路径和虚影机械臂；真实机械臂不会运动</translation>
    </message>
    <message>
        <source>Save as recording</source>
        <translation>保存为录制</translation>
    </message>
    <message>
        <source>Save as points</source>
        <translation>保存为轨迹点</translation>
    </message>
    <message>
        <source>Imported file, or of an unknown arm: {time}, {count} samples, {size}</source>
        <translation>导入的文件，或所属机械臂未知：{time}，{count} 个采样，{size}</translation>
    </message>
    <message>
        <source>Recorded: {time}, {count} samples, {size}</source>
        <translation>已录制：{time}，{count} 个采样，{size}</translation>
    </message>
    <message>
        <source>The arm comes to rest in every point</source>
        <translation>机械臂会在每个点停下</translation>
    </message>
    <message>
        <source>It is in memory alone until it is saved. {reason}</source>
        <translation>保存前数据只在内存中。{reason}</translation>
    </message>
</context>
<context>
    <name>RecoveryAction</name>
    <message>
        <source>Connect…</source>
        <translation>连接…</translation>
    </message>
    <message>
        <source>Motion output</source>
        <translation>运动输出臂</translation>
    </message>
    <message>
        <source>Release the emergency stop</source>
        <translation>解除急停</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Clear error</source>
        <translation>清除错误</translation>
    </message>
    <message>
        <source>Reset…</source>
        <translation>复位…</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>结束示教记录</translation>
    </message>
    <message>
        <source>Terminate</source>
        <translation>终止执行</translation>
    </message>
    <message>
        <source>Lead by hand…</source>
        <translation>拖动…</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>知道了</translation>
    </message>
    <message>
        <source>Take command…</source>
        <translation>待机…</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Release (the arm drops)</source>
        <translation>解除急停（机械臂会下落）</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>接管</translation>
    </message>
    <message>
        <source>Withdraw…</source>
        <translation>撤回…</translation>
    </message>
    <message>
        <source>Take back…</source>
        <translation>收回控制…</translation>
    </message>
    <message>
        <source>Release ends the braking by the motors: the arm will drop. Hold the arm.
Afterwards the motors must be enabled again.</source>
        <translation>解除急停会结束电机的阻尼：机械臂会下落，请扶住机械臂。
之后须重新使能电机。</translation>
    </message>
    <message>
        <source>Reset the arm</source>
        <translation>复位机械臂</translation>
    </message>
    <message>
        <source>First the emergency stop: the motors only brake and the arm sinks. Then Release ends even that: the arm will drop. Hold the arm from now on.</source>
        <translation>先急停：电机只起阻尼作用，机械臂会缓慢下沉；随后解除急停，阻尼也消失：机械臂会下落，请扶住机械臂。</translation>
    </message>
    <message>
        <source>Lead the arm by hand</source>
        <translation>用手拖动机械臂</translation>
    </message>
    <message>
        <source>The arm will give way to the hand and starts a new recording; the one it holds is lost. Hold the arm.
When you are done, lead it back near its zero pose before you stop the recording.</source>
        <translation>机械臂将进入拖动示教模式并开始新的记录，原有记录会丢失。请扶住机械臂。
示教完成后，先把机械臂拖回零位附近，再结束记录。</translation>
    </message>
    <message>
        <source>Take the arm back</source>
        <translation>收回机械臂的控制</translation>
    </message>
    <message>
        <source>The arm changes back to its own control and is told to hold where it stands. Between the two its joints are limp for a moment: it may sag, and drop if the second message is lost. Hold the arm.
The other program must have ended.</source>
        <translation>机械臂将切回自身的控制方式，并被告知保持在当前位置。两条指令之间关节会短暂失力：机械臂可能下沉，若第二条指令丢失则会下落。请扶住机械臂。
另一程序必须已经结束。</translation>
    </message>
    <message>
        <source>Move inside</source>
        <translation>回到限位内</translation>
    </message>
    <message>
        <source>Withdraw the stop</source>
        <translation>撤回急停</translation>
    </message>
    <message>
        <source>The arm is not stopped: it goes on with whatever it is doing, and obeys again. Look at the arm before.</source>
        <translation>机械臂不会停止：它将继续正在做的动作，并重新服从指令。请先看清机械臂。</translation>
    </message>
    <message>
        <source>Take the command</source>
        <translation>切换到待机模式</translation>
    </message>
    <message>
        <source>The arm will no longer follow the other control; a motion under way ends. Make sure that nobody relies on it.</source>
        <translation>机械臂将不再由其他方式控制，正在进行的运动会停止。请确认无人正在使用。</translation>
    </message>
    <message>
        <source>Go on without the cell</source>
        <translation>不用单元继续</translation>
    </message>
    <message>
        <source>Move anyway…</source>
        <translation>仍要运动…</translation>
    </message>
    <message>
        <source>Nothing of the cell holds then, neither its tools nor anything it forbids. Its file is left as it is.</source>
        <translation>之后单元的任何内容都不生效，包括它的工具和它所禁止的。其文件保持不变。</translation>
    </message>
    <message>
        <source>Without it…</source>
        <translation>不用它…</translation>
    </message>
    <message>
        <source>Confirm cell</source>
        <translation>确认单元</translation>
    </message>
    <message>
        <source>A joint in doubt may stand up to 85° from what it reports: the arm then goes another way than the picture and the check show, and may strike itself or the table. Runs and faster motions may begin for one minute. Keep a hand on the stop.</source>
        <translation>存疑的关节与上报位置最多可能相差 85°：机械臂的实际路径会与画面和检查结果不同，可能撞到自身或桌面。一分钟内可以开始轨迹运行和较快的运动。请把手放在急停上。</translation>
    </message>
    <message>
        <source>Reference check…</source>
        <translation>零位基准检查…</translation>
    </message>
    <message>
        <source>Move with the reference in doubt</source>
        <translation>零位基准存疑时运动</translation>
    </message>
</context>
<context>
    <name>RecoveryLine</name>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>“{name}” has not started: the check asks first. Read what was found, and press the button beside it.</source>
        <translation>“{name}”尚未运行：检查后需要确认。请阅读检查结果，再按其旁边的按钮。</translation>
    </message>
    <message>
        <source>Below the arm: {names}.</source>
        <translation>机械臂下方是 {names}。</translation>
    </message>
    <message>
        <source>Waiting…</source>
        <translation>等待中…</translation>
    </message>
    <message>
        <source>Waiting for the arm</source>
        <translation>等待机械臂</translation>
    </message>
    <message>
        <source>Another way</source>
        <translation>另一种选择</translation>
    </message>
</context>
<context>
    <name>RecoveryStep</name>
    <message>
        <source>The device is being opened.</source>
        <translation>正在打开设备。</translation>
    </message>
    <message>
        <source>The CAN device is gone: cut the arm&apos;s power if it moves.</source>
        <translation>CAN 设备已断开：若机械臂在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>The arm is a teaching input: it sends commands and obeys none. Hold it: as a motion output again its six motors hold it under power, or let it drop.</source>
        <translation>该机械臂是示教输入臂：只发送控制指令，不响应控制指令。请扶住：恢复为运动输出臂后，六个电机带电保持，或机械臂会下落。</translation>
    </message>
    <message>
        <source>The arm has NOT confirmed the stop; it is sent again and again. Cut its power if it moves.</source>
        <translation>机械臂未确认急停，正在反复发送。若机械臂仍在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>Stop sent. Waiting for the arm to confirm it.</source>
        <translation>已发送急停，等待机械臂确认。</translation>
    </message>
    <message>
        <source>Nothing is heard from the arm. Check its power, the CAN cable and the bit rate, or whether this computer is too busy.</source>
        <translation>未收到机械臂的反馈。请检查电源、CAN 线和波特率，或本机是否过忙。</translation>
    </message>
    <message>
        <source>The adapter sends, but hears nothing, not even errors. Unplug it and plug it in again.</source>
        <translation>适配器能发送，却什么也收不到，连错误也没有。请拔下再插上。</translation>
    </message>
    <message>
        <source>Waiting for the arm: {what}.</source>
        <translation>等待机械臂：{what}。</translation>
    </message>
    <message>
        <source>Emergency stop: the motors only brake. Support the arm: released, it drops.</source>
        <translation>急停中：电机只起阻尼作用。请扶住机械臂：解除急停后机械臂会下落。扶稳后再解除。</translation>
    </message>
    <message>
        <source>Emergency stop. Support the arm: its release drops it and makes it a teaching input, deaf even to the stop.</source>
        <translation>急停中。请扶住机械臂：解除急停后会下落，并成为示教输入臂，此后急停也无效。</translation>
    </message>
    <message>
        <source>The arm is being asked for its protocol.</source>
        <translation>正在查询机械臂的协议。</translation>
    </message>
    <message>
        <source>The arm sends no complete feedback. If it stays so, check its power and connect again.</source>
        <translation>机械臂反馈不完整。若持续如此，请检查电源并重新连接。</translation>
    </message>
    <message>
        <source>No communication with joint {joints}. Check its cable; if the message stays, reset the arm.</source>
        <translation>关节 {joints} 通信异常。请检查关节线缆；若提示不消失，请复位机械臂。</translation>
    </message>
    <message>
        <source>Collision, joint {joints}. Remove what the arm hit, then clear the error.</source>
        <translation>机械臂发生碰撞，关节 {joints}。请移开障碍物，然后清除错误。</translation>
    </message>
    <message>
        <source>Overcurrent, joint {joints}: its motor may be off. Hold the arm, take the load away, clear the error.</source>
        <translation>关节 {joints} 驱动器过流，电机可能已断电。请扶住机械臂，卸下负载，然后清除错误。</translation>
    </message>
    <message>
        <source>Stalled: joint {joints}. Free it, then clear the error.</source>
        <translation>关节 {joints} 堵转。请解除卡阻，然后清除错误。</translation>
    </message>
    <message>
        <source>Sensor fault, joint {joints}. Clear the error; if it comes back, check the joint&apos;s encoder.</source>
        <translation>关节 {joints} 传感器异常。请清除错误；若再次出现，请检查该关节编码器。</translation>
    </message>
    <message>
        <source>Supply voltage too low, joint {joints}. Check the 24 V supply; the arm goes on by itself.</source>
        <translation>关节 {joints} 电源电压过低。请检查 24 V 电源，恢复后自动继续。</translation>
    </message>
    <message>
        <source>The arm reports a joint status fault. Look at the joint status, then clear the errors.</source>
        <translation>机械臂报告关节状态异常。请查看关节状态，然后清除错误。</translation>
    </message>
    <message>
        <source>A joint&apos;s brake is not released. Hold the arm, then reset it.</source>
        <translation>关节抱闸未打开。请扶住机械臂，然后复位。</translation>
    </message>
    <message>
        <source>The main controller is too hot. Let it cool down; if the message stays, reset the arm.</source>
        <translation>主控过温。请等待冷却；若提示不消失，请复位机械臂。</translation>
    </message>
    <message>
        <source>The brake resistor is too hot. Let it cool down; if the message stays, reset the arm.</source>
        <translation>释放电阻过温。请等待冷却；若提示不消失，请复位机械臂。</translation>
    </message>
    <message>
        <source>The arm reports an unspecified fault. Look at the joint status, then reset the arm.</source>
        <translation>机械臂报告其它异常。请查看关节状态，然后复位机械臂。</translation>
    </message>
    <message>
        <source>The arm reports a status this program does not know ({status}). Reset the arm.</source>
        <translation>机械臂报告未知状态（{status}）。请复位机械臂。</translation>
    </message>
    <message>
        <source>The arm records: lead it by hand. Stop recording when done.</source>
        <translation>正在示教记录：请用手拖动机械臂，完成后结束示教记录。</translation>
    </message>
    <message>
        <source>The arm replays what it was taught. Keep clear.</source>
        <translation>正在执行示教轨迹，请勿靠近。</translation>
    </message>
    <message>
        <source>The arm takes its commands from elsewhere: {mode}. Take the command.</source>
        <translation>机械臂由其他方式控制：{mode}。请切换到待机模式。</translation>
    </message>
    <message>
        <source>The arm was told to end its motion and still moves. Stop it, or cut its power.</source>
        <translation>已命令机械臂终止运动，但它仍在动。请急停，或切断其电源。</translation>
    </message>
    <message>
        <source>Still in drag teaching, near the rest pose. Hold the arm and reset it; if it stays, switch it off and on.</source>
        <translation>仍处于示教模式，已接近零位。请扶住机械臂并复位；若仍未退出，请重新上电。</translation>
    </message>
    <message>
        <source>Still in drag teaching, joint {joint} at {angle}°. Enable the motors, then lead the arm to its rest pose.</source>
        <translation>仍处于示教模式，关节 {joint} 在 {angle}°。请先使能电机，再将机械臂拖动到零位附近。</translation>
    </message>
    <message>
        <source>Dragged too fast: the recording has ended. Lead the arm slowly to within {near}° of zero (joint {joint}: {angle}°).</source>
        <translation>拖动示教时超速，记录已结束。请缓慢拖动各关节到零位 {near}° 以内（关节 {joint}：{angle}°）。</translation>
    </message>
    <message>
        <source>Still in drag teaching. Lead every joint by hand to within {near}° of zero (joint {joint}: {angle}°).</source>
        <translation>仍处于示教模式。请用手将各关节拖动到零位 {near}° 以内（关节 {joint}：{angle}°）。</translation>
    </message>
    <message>
        <source>The arm was dragged too fast. Hold it, then reset it.</source>
        <translation>拖动示教时超速。请扶住机械臂，然后复位。</translation>
    </message>
    <message>
        <source>Without power: joint {joints}. Hold the arm, then enable the motors.</source>
        <translation>关节 {joints} 的电机未使能。请扶住机械臂，然后使能。</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>The motors are off. Enable them to move the arm.</source>
        <translation>电机未使能。使能后可运动。</translation>
    </message>
    <message>
        <source>At the resume the feedback jumped: {joints}. By so much the joint stood elsewhere than it reported; what was taught or set as zero before may be off by it.</source>
        <translation>解除急停时反馈跳变：{joints}。关节的实际位置与上报值相差这么多；此前示教的点或设置的零点可能有同样的偏差。</translation>
    </message>
    <message>
        <source>Outside its limits, as a resting arm lies: {outside}. Until it is brought inside the arm takes only a run, or a target with all joints inside; hold Move inside: these move slowly, all at once, then J5 if the hand lies on the base.</source>
        <translation>位于限位之外（静置的机械臂即如此）：{outside}。回到限位内之前，机械臂只接受轨迹运行或各关节均在限位内的目标；请按住“回到限位内”：这些关节一起缓慢移动，手部贴着底座时 J5 随后也会移动。</translation>
    </message>
    <message>
        <source>Outside its limits: {outside}. Hold Move inside.</source>
        <translation>位于限位之外：{outside}。请按住“回到限位内”。</translation>
    </message>
    <message>
        <source>Paused: with the speed above 0 %, hold “Continue” for 1 s</source>
        <translation>已暂停：速度高于 0 % 时，按住“继续”1 秒</translation>
    </message>
    <message>
        <source>The fingertip is {value} mm below the lowest height for motions. None goes lower: jog upwards, or change that height in the settings.</source>
        <translation>指尖比运动最低高度低 {value} mm，无法再向下运动。请向上点动，或在设置中更改该高度。</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>A joint no longer communicates. Check the cables; if the message stays, reset the arm.</source>
        <translation>关节通信异常。请检查关节线缆；若提示不消失，请复位机械臂。</translation>
    </message>
    <message>
        <source>The arm has hit something. Remove it, then clear the errors.</source>
        <translation>机械臂发生碰撞。请移开障碍物，然后清除错误。</translation>
    </message>
    <message>
        <source>A stop is outstanding: it goes out once the CAN device is back. Cut the arm&apos;s power if it moves.</source>
        <translation>有一次急停未完成：CAN 设备恢复后立即发出。若机械臂在运动，请切断其电源。</translation>
    </message>
    <message>
        <source>A stop is outstanding, and the arm is away. Cut its power if it moves, or connect to it and press the emergency stop.</source>
        <translation>有一次急停未完成，机械臂不在线。若它在运动，请切断其电源，或连接后按急停。</translation>
    </message>
    <message>
        <source>A stop is outstanding: the arm was away and has not confirmed it. Press the emergency stop to send it now, or withdraw it.</source>
        <translation>有一次急停未完成：机械臂曾离线，没有确认。按急停立即发送，或撤回。</translation>
    </message>
    <message>
        <source>No arm is connected. Connect one, or the simulated arm to try everything out.</source>
        <translation>未连接机械臂。请连接机械臂，或先用仿真机械臂试用全部功能。</translation>
    </message>
    <message>
        <source>The CAN device is gone: no stop reaches the arm. Cut its power if it moves. Plug the device in again, or choose another one.</source>
        <translation>CAN 设备已断开，停止指令到不了机械臂：若它在运动，请切断其电源。请重新插好设备，或选择其他设备。</translation>
    </message>
    <message>
        <source>{device} is bus-off: after too many errors it neither sends, not even a stop, nor hears. Check CAN_H and CAN_L, both 120 Ω resistors and the bit rate, then connect again.</source>
        <translation>{device} 已总线关闭（bus-off）：错误过多，既不能接收也不能发送，包括急停。请检查 CAN_H 与 CAN_L、两端 120 Ω 终端电阻和波特率，然后重新连接。</translation>
    </message>
    <message>
        <source>{device} is bus-off: it sends nothing, not even a stop.</source>
        <translation>{device} 已总线关闭（bus-off）：什么也发不出，包括急停。</translation>
    </message>
    <message>
        <source>Only listening: nothing is sent but the emergency stop. To move the arm, disconnect here, then connect without “Listen only”.</source>
        <translation>只听：除急停外不发送任何帧。要控制机械臂，请在此断开，再不勾选“只听”重新连接。</translation>
    </message>
    <message>
        <source>Driver error, joint {joints}: its motor may be off. Hold the arm, then clear the error.</source>
        <translation>关节 {joints} 驱动器错误，电机可能已断电。请扶住机械臂，然后清除错误。</translation>
    </message>
    <message>
        <source>Too hot, joint {joints}: {temperature} °C. Let the arm cool down; the message goes by itself.</source>
        <translation>关节 {joints} 过温：{temperature} °C。请等待冷却，恢复后提示自动消失。</translation>
    </message>
    <message>
        <source>Another program drives the arm in {other_mode} mode. Nothing is sent by itself: a new mode leaves the joints limp. Stop that program first.</source>
        <translation>另一程序正以{other_mode}模式驱动机械臂。本程序不会自行发送任何指令：切换模式会使关节失力。请先停止该程序。</translation>
    </message>
    <message>
        <source>Last used here: the cell “{name}”, the gripper holding “{held}”. Confirm both if they are there; if the gripper is empty, let go under Cell first.</source>
        <translation>上次在此使用的单元是“{name}”，夹爪夹着“{held}”。两者都属实请确认；如夹爪是空的，请先在“单元”中标为“已放下”。</translation>
    </message>
    <message>
        <source>Another program controls the arm since {since} ({frames}).</source>
        <translation>另一程序正在控制机械臂：自 {since} 起（{frames}）。</translation>
    </message>
    <message>
        <source>A leader arm moves this arm since {since} ({frames}).</source>
        <translation>主臂正在带动本机械臂：自 {since} 起（{frames}）。</translation>
    </message>
    <message>
        <source>The arm holds back a paused motion to {target}. Hold “Continue” for 1 s, or give it up.</source>
        <translation>机械臂保留着已暂停的运动，目标 {target}。按住“继续”1 秒，或放弃它。</translation>
    </message>
    <message>
        <source>The arm holds back a motion to {target} at 0 %. Set a speed and hold “Continue” for 1 s, or give it up.</source>
        <translation>速度为 0 %，机械臂保留着运动，目标 {target}。请设定速度后按住“继续”1 秒，或放弃它。</translation>
    </message>
    <message>
        <source>Nothing is heard from the motor of joint {joints}. If it stays so, check power and cable, and connect again.</source>
        <translation>没有收到关节 {joints} 的电机反馈。若持续如此，请检查电源和线缆，然后重新连接。</translation>
    </message>
    <message>
        <source>Joint {joints} beyond its limit: the target was not taken. Send one within the limits.</source>
        <translation>关节 {joints} 超出限位：目标未被执行。请发送限位内的目标。</translation>
    </message>
    <message>
        <source>The last target is beyond a limit and was not taken. Send another one.</source>
        <translation>上一个目标超出限位，未被执行。请发送其他目标。</translation>
    </message>
    <message>
        <source>The last target has no solution and was not taken. Send another one.</source>
        <translation>上一个目标无解，未被执行。请发送其他目标。</translation>
    </message>
    <message>
        <source>The way to the last target is singular, and it was not taken. Send another target, or by joints.</source>
        <translation>到上一个目标的路径经过奇异点，目标未被执行。请发送其他目标，或按关节发送。</translation>
    </message>
    <message>
        <source>Waiting: press “Next step”</source>
        <translation>等待中：请按“下一步”</translation>
    </message>
    <message>
        <source>A trajectory is running</source>
        <translation>正在执行轨迹</translation>
    </message>
    <message>
        <source>The fingertip is {value} mm below the floor. Jog upwards unless there is nothing there. Settings have a lowest height for motions.</source>
        <translation>指尖在地面以下 {value} mm。除非那里没有物体，请向上点动。“设置”中可选运动的最低高度。</translation>
    </message>
    <message>
        <source>Another program may have left a motion held back in the arm. Give it up, or go on with it there; the next motion from here cancels it.</source>
        <translation>机械臂中可能留有其他程序暂停的运动。请放弃，或在那里继续；本程序的下一次运动会将其取消。</translation>
    </message>
    <message>
        <source>The arm is moving</source>
        <translation>机械臂正在运动</translation>
    </message>
    <message>
        <source>The replay is paused. Hold “Continue” for 1 s under Drag teaching, or terminate it.</source>
        <translation>示教轨迹已暂停。可在【示教】中按住“继续执行”1 秒，或终止执行。</translation>
    </message>
    <message>
        <source>Joint {joints} left its place uncommanded while it was enabled: it may stand elsewhere than it reports. Check its reference.</source>
        <translation>关节 {joints} 在使能且无指令时离开了原来的位置：实际位置可能与上报不符。请检查其零位基准。</translation>
    </message>
    <message>
        <source>Last used here: the cell “{name}”. Is this its arm? Confirm it, or choose under Cell.</source>
        <translation>此处上次使用的单元：“{name}”。是这台机械臂吗？请确认，或在“单元”中选择。</translation>
    </message>
    <message>
        <source>The reference is being checked: nothing moves but what the check drives.</source>
        <translation>正在检查零位基准：除检查本身驱动的关节外，一律不动。</translation>
    </message>
    <message>
        <source>The cell “{name}” kept for this arm could not be read. Choose another one under Cell.</source>
        <translation>为此机械臂保存的单元“{name}”无法读取。请在“单元”中另选一个。</translation>
    </message>
    <message>
        <source>The arm is {value} mm too near to “{name}” of the work area ({part}). It can only be moved out: jog the other way, or lead it by hand.</source>
        <translation>机械臂离工作区的“{name}”过近，差 {value} mm（{part}）。只能向外移动：请反向点动，或用手拖动。</translation>
    </message>
    <message>
        <source>Motions are agreed to, though joint {joints} may stand elsewhere than it reports.</source>
        <translation>已同意运动，但关节 {joints} 的实际位置可能与上报不符。</translation>
    </message>
    <message>
        <source>{frames}, {rate} frames/s</source>
        <translation>{frames}，{rate} 帧/秒</translation>
    </message>
    <message>
        <source>{does}. {text}</source>
        <translation>{does}。{text}</translation>
    </message>
    <message>
        <source>Motion is locked: {obstacle}</source>
        <translation>运动已锁定：{obstacle}</translation>
    </message>
</context>
<context>
    <name>Reference</name>
    <message>
        <source>never checked</source>
        <translation>从未检查</translation>
    </message>
    <message>
        <source>joint {joints} in doubt since {time}</source>
        <translation>关节 {joints} 自 {time} 起存疑</translation>
    </message>
    <message>
        <source>last checked {time}: all joints fit</source>
        <translation>上次检查 {time}：全部关节相符</translation>
    </message>
    <message>
        <source>; </source>
        <translation>；</translation>
    </message>
    <message>
        <source>No resume (0x150) was seen</source>
        <translation>未见过解除急停（0x150）</translation>
    </message>
    <message>
        <source>None; last resume {time}</source>
        <translation>无；上次解除急停 {time}</translation>
    </message>
    <message>
        <source>Not heard enough at {time} to tell</source>
        <translation>{time} 收到的反馈太少，无法判断</translation>
    </message>
    <message>
        <source>Never inspected</source>
        <translation>从未巡检</translation>
    </message>
    <message>
        <source>{time}: joint {joints} stands out</source>
        <translation>{time}：关节 {joints} 异常</translation>
    </message>
    <message>
        <source>{time}: nothing stands out</source>
        <translation>{time}：无异常</translation>
    </message>
    <message>
        <source>; joint {joints} was not measured</source>
        <translation>；关节 {joints} 未测量</translation>
    </message>
    <message>
        <source>last checked {time}: {off} off</source>
        <translation>上次检查 {time}：{off} 偏差</translation>
    </message>
</context>
<context>
    <name>ReferenceDialog</name>
    <message>
        <source>Off by</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>相符</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>off by {off}</source>
        <translation>偏差 {off}</translation>
    </message>
    <message>
        <source>Finish the check</source>
        <translation>完成检查</translation>
    </message>
    <message>
        <source>Off by this</source>
        <translation>确有偏差</translation>
    </message>
    <message>
        <source>The others stand as shown</source>
        <translation>其余与画面相符</translation>
    </message>
    <message>
        <source>Joint {joint} has no mark, and no reference pose is taught. Compare it with the picture: does it stand as shown? If not, type by how much it is off.</source>
        <translation>关节 {joint} 没有刻线，也没有示教基准位姿。请与画面比较：是否如画面所示？若不是，请输入偏差。</translation>
    </message>
    <message>
        <source>At the mark</source>
        <translation>刻线处</translation>
    </message>
    <message>
        <source>Keep this pose</source>
        <translation>保存此位姿</translation>
    </message>
    <message>
        <source>Joint {joint} goes limp, and what hangs on it drops: hold the arm with both hands. The other joints keep their power.</source>
        <translation>关节 {joint} 将失去动力，其后的部分会下落：请用双手扶住机械臂。其他关节保持使能。</translation>
    </message>
    <message>
        <source>Teach reference pose…</source>
        <translation>示教基准位姿…</translation>
    </message>
    <message>
        <source>Reference check</source>
        <translation>零位基准检查</translation>
    </message>
    <message>
        <source>The check takes some two minutes. A joint in doubt is brought to its mark by hand; the others are driven slowly, each by a held button.</source>
        <translation>检查约需两分钟。存疑的关节用手转到刻线；其他关节缓慢驱动，每个都要按住按钮确认。</translation>
    </message>
    <message>
        <source>Motor off…</source>
        <translation>电机关闭…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Drive to the mark</source>
        <translation>驱动到刻线</translation>
    </message>
    <message>
        <source>All joints are answered for, and some are off. Finish the check: they stay in doubt, and what can be done is shown then.</source>
        <translation>全部关节均已回答，其中有偏差。请完成检查：有偏差的关节仍然存疑，随后显示可采取的措施。</translation>
    </message>
    <message>
        <source>Begin the check</source>
        <translation>开始检查</translation>
    </message>
    <message>
        <source>Joint {joint} may stand 85° from what it reports: nothing drives it. Hold the arm, switch its motor off and turn it to {place} by hand; then press “Stands at its mark”. What it reports there shows how far it is off.</source>
        <translation>关节 {joint} 与上报位置最多可能相差 85°：不会驱动它。扶住机械臂，关闭该关节的电机，用手转到{place}，再按“已对准刻线”。此时的上报角度即显示偏差。</translation>
    </message>
    <message>
        <source>Does each joint stand where it reports? The feedback alone cannot tell.</source>
        <translation>每个关节是否在上报的位置？仅凭反馈无法判断。</translation>
    </message>
    <message>
        <source>Teach the reference pose</source>
        <translation>示教基准位姿</translation>
    </message>
    <message>
        <source>The motor is off.</source>
        <translation>该电机已失能。</translation>
    </message>
    <message>
        <source>Type first by how much it is off.</source>
        <translation>请先输入偏差值。</translation>
    </message>
    <message>
        <source>No joint is answered yet.</source>
        <translation>还没有任何关节作出回答。</translation>
    </message>
    <message>
        <source>Look at the whole arm beside the picture, which shows what it reports. Tick each joint that stands elsewhere than the picture shows. Nothing drives those joints; any that is in doubt is ticked already.</source>
        <translation>对照画面查看整台机械臂，画面显示的是它上报的位置。勾选实际位置与画面不同的关节。这些关节不会被驱动；如有存疑的关节，则已勾选。</translation>
    </message>
    <message>
        <source>its place in the reference pose</source>
        <translation>基准位姿中的位置</translation>
    </message>
    <message>
        <source>Stands at its mark</source>
        <translation>已对准刻线</translation>
    </message>
    <message>
        <source>in doubt</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>its mark</source>
        <translation>刻线</translation>
    </message>
    <message>
        <source>What can be done: (1) Reset with the arm held. Emergency stop, hold the arm, Release: its motors lose their power and the arm drops; the arm then finds its reference again. Enable, and check once more. (2) Set the joint&apos;s zero, only if a reset does not help and the joint stands at its mark: nothing moves, but every angle, limit and saved point counts from there. Neither ends the doubt: only this check does.</source>
        <translation>可采取的措施：(1) 扶住机械臂后复位。急停，扶住机械臂，解除急停：电机断电，机械臂下落，随后重新找到零位基准。使能后再检查一次。(2) 设置该关节的零点，仅当复位无效且关节对准刻线时：机械臂不动，但此后所有角度、限位和已保存的点都从这里计算。两者都不会消除存疑：只有本检查可以。</translation>
    </message>
    <message>
        <source>The photo cannot be read.</source>
        <translation>照片无法读取。</translation>
    </message>
    <message>
        <source>Motor off</source>
        <translation>电机关闭</translation>
    </message>
    <message>
        <source>Switch off the motor of joint {joint}</source>
        <translation>关闭关节 {joint} 的电机</translation>
    </message>
    <message>
        <source>Photo of the arm in its reference pose</source>
        <translation>机械臂基准位姿的照片</translation>
    </message>
    <message>
        <source>Switch its motor off and turn it by hand first.</source>
        <translation>请先关闭该关节的电机并用手转动。</translation>
    </message>
    <message>
        <source>Answer again</source>
        <translation>重新回答</translation>
    </message>
    <message>
        <source>Where the arm stands now is kept as its reference pose: joints 2 and 3, which have no mark, are compared with it. Put the arm where you will recognise it to the degree, for example with the fingertip on a cross on the table. You may then choose a photo of it. Only teach it while the reference is right.</source>
        <translation>机械臂当前的位置将保存为基准位姿：没有刻线的关节 2 和 3 与它比较。请把机械臂放到能精确到度辨认的位置，例如指尖对准桌面上的十字。随后可以选择一张照片。只有在零位基准正确时才可示教。</translation>
    </message>
    <message>
        <source>Reported</source>
        <translation>上报</translation>
    </message>
    <message>
        <source>Pictures ({kinds})</source>
        <translation>图片 ({kinds})</translation>
    </message>
    <message>
        <source>Hold “Drive to the mark”: joint {joint} goes to {place} at 5 %, the others stay. Look whether it then stands there. If not, type by how much it is off.</source>
        <translation>按住“驱动到刻线”：关节 {joint} 以 5 % 速度转到{place}，其他关节不动。查看它是否到位。若未到位，请输入偏差。</translation>
    </message>
    <message>
        <source>All joints stand where they report. Finish the check to keep that.</source>
        <translation>全部关节都在上报的位置。完成检查即可保存结果。</translation>
    </message>
    <message>
        <source>Move anyway</source>
        <translation>仍要运动</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>No arm is connected. Click the button at the top left, choose a device and connect it.</source>
        <translation>尚未连接机械臂。请点击左上角的通讯按钮，选择设备并连接。</translation>
    </message>
    <message>
        <source>The device is open, but nothing is heard from the arm. Check its power, the CAN cable and the bit rate, or whether this computer is too busy.</source>
        <translation>CAN 设备已打开，但没有收到机械臂的反馈。请检查机械臂电源、CAN 线和波特率，或本机是否过忙。</translation>
    </message>
    <message>
        <source>The CAN device is gone. Plug it in again: the program reconnects by itself.</source>
        <translation>CAN 设备已断开。请重新插好设备，程序会自动重新连接。</translation>
    </message>
    <message>
        <source>The emergency stop has been sent and the arm has not confirmed it yet. Wait for the confirmation.</source>
        <translation>急停已发送，机械臂尚未确认。请等待确认。</translation>
    </message>
    <message>
        <source>Still under way: {what}. Wait until it is done.</source>
        <translation>正在进行：{what}。请等待完成。</translation>
    </message>
    <message>
        <source>The motors of these joints are not enabled: {joints}. Press Enable first.</source>
        <translation>以下关节的电机未使能：{joints}。请先按“使能”。</translation>
    </message>
    <message>
        <source>Not every motor has reported yet whether it is enabled. Wait a moment; if it stays so, check the arm&apos;s power and the CAN cable.</source>
        <translation>尚未收到全部电机的使能状态。请稍候；若一直如此，请检查机械臂电源和 CAN 线。</translation>
    </message>
    <message>
        <source>The speed is set to 0 %: the arm would not move. Set a speed from 1 to 100 % at the top.</source>
        <translation>速度百分比为 0 %，机械臂不会运动。请在窗口上方设置 1～100 % 的速度。</translation>
    </message>
    <message>
        <source>The tool or what is held would come to {value} mm; motions end at {minimum} mm, as chosen under Settings. Move upwards.</source>
        <translation>末端或工件将到达 {value} mm；按“设置”中的选择，运动止于 {minimum} mm。请向上移动。</translation>
    </message>
    <message>
        <source>Its limits are {minimum}° and {maximum}°.</source>
        <translation>其限位为 {minimum}° 和 {maximum}°。</translation>
    </message>
    <message>
        <source>Speed {value} % is out of range. Enter a value from 0 to 100 %.</source>
        <translation>速度 {value} % 超出范围。请输入 0～100 %。</translation>
    </message>
    <message>
        <source>Joint {joint}: “{value}” is not an angle. Enter a number of degrees, for example 12.5.</source>
        <translation>关节 {joint}：“{value}”不是角度。请输入以度为单位的数字，例如 12.5。</translation>
    </message>
    <message>
        <source>The arm takes its commands from elsewhere: {mode}. Leave that mode first.</source>
        <translation>机械臂当前不由本程序控制：{mode}。请先退出该模式。</translation>
    </message>
    <message>
        <source>The arm&apos;s state has changed: nothing was sent. Look at the step that is shown now.</source>
        <translation>机械臂状态已变化，未发送。请查看当前提示。</translation>
    </message>
    <message>
        <source>The arm did not react.</source>
        <translation>机械臂无响应。</translation>
    </message>
    <message>
        <source>The arm is not in drag teaching. Start recording first, or press the button on the arm.</source>
        <translation>机械臂未进入示教模式。请先开始示教记录，或按下机械臂上的示教按键。</translation>
    </message>
    <message>
        <source>Nothing is under way in drag teaching. Start recording or replay first.</source>
        <translation>示教没有正在进行的动作。请先开始示教记录或执行示教轨迹。</translation>
    </message>
    <message>
        <source>The arm is recording. Stop recording first.</source>
        <translation>正在示教记录。请先结束示教记录。</translation>
    </message>
    <message>
        <source>The arm is replaying. Pause or terminate the replay first.</source>
        <translation>正在执行示教轨迹。请先暂停执行或终止执行。</translation>
    </message>
    <message>
        <source>The replay is paused. Continue or terminate it first.</source>
        <translation>示教轨迹已暂停。请先继续执行或终止执行。</translation>
    </message>
    <message>
        <source>The arm is not moving: there is nothing to pause.</source>
        <translation>机械臂未在运动，无需暂停。</translation>
    </message>
    <message>
        <source>The arm is still moving. Wait until it stands still, then press again.</source>
        <translation>机械臂仍在运动。请等它停稳后再按。</translation>
    </message>
    <message>
        <source>J{joint} is at its limit of {limit}°. Jog the other way.</source>
        <translation>J{joint} 已到限位 {limit}°，请向反方向点动。</translation>
    </message>
    <message>
        <source>The arm can reach no further this way. Jog in another direction.</source>
        <translation>机械臂在此方向已到可达范围的边缘。请换一个方向点动。</translation>
    </message>
    <message>
        <source>The arm is at a singular pose: joint {joint} would have to turn far too fast. Jog another way, or turn joint 5 away from 0° under Motion control.</source>
        <translation>机械臂处于奇异位姿：关节 {joint} 需要转得过快。请换一个方向点动，或在运动控制中把关节 5 转离 0°。</translation>
    </message>
    <message>
        <source>The arm does not follow. Check that nothing blocks it and what its status says.</source>
        <translation>机械臂没有跟随。请检查是否有阻挡，并查看机械臂状态。</translation>
    </message>
    <message>
        <source>The joint angles are no longer heard from the arm. Check its power and the CAN cable.</source>
        <translation>收不到机械臂的关节角度。请检查电源和 CAN 线。</translation>
    </message>
    <message>
        <source>The program was held up for {value} ms. Let go and press again.</source>
        <translation>程序停顿了 {value} 毫秒。请松开后重新按下。</translation>
    </message>
    <message>
        <source>The arm itself refuses its last target: {status}. Send another one.</source>
        <translation>机械臂拒绝了上一个目标：{status}。请发送其他目标。</translation>
    </message>
    <message>
        <source>{axis}: “{value}” is not a number. Enter mm or degrees, for example 12.5.</source>
        <translation>{axis}：“{value}”不是数值。请输入毫米或度的数字，例如 12.5。</translation>
    </message>
    <message>
        <source>The target is {missing} mm out of the arm&apos;s reach. Choose one nearer to the arm, or turn the tool.</source>
        <translation>目标超出可达范围，还差 {missing} mm。请选择更近的位置，或改变末端姿态。</translation>
    </message>
    <message>
        <source>At the target joint {joint} would stand at {value}°, beyond its limits of {minimum}° to {maximum}°. Choose another position or turn the tool.</source>
        <translation>在目标处关节 {joint} 将为 {value}°，超出限位 {minimum}° 至 {maximum}°。请选择其他位置或改变末端姿态。</translation>
    </message>
    <message>
        <source>After {gone} % of the way the arm reaches no further. Choose MOVE P, or another target.</source>
        <translation>走到路径的 {gone} % 处超出可达范围。请改用 MOVE P，或选择其他目标。</translation>
    </message>
    <message>
        <source>The arm would hit itself: {other} against {one}. Move another way.</source>
        <translation>机械臂会碰到自身：{other} 与 {one}。请换一条路径。</translation>
    </message>
    <message>
        <source>The arm touches itself: {other} against {one}; this would press them together. Move them apart.</source>
        <translation>机械臂碰到自身：{other} 与 {one}；此运动会使其压得更紧。请将其分开。</translation>
    </message>
    <message>
        <source>After {gone} % of the way joint {joint} would be at {value}°, beyond its limits of {minimum}° to {maximum}°. Choose MOVE P, or another target.</source>
        <translation>走到路径的 {gone} % 处关节 {joint} 将为 {value}°，超出限位 {minimum}° 至 {maximum}°。请改用 MOVE P，或选择其他目标。</translation>
    </message>
    <message>
        <source>After {gone} % of the way the arm comes to a singular pose: joint {joint} would have to jump. Choose MOVE P, or move joint 5 away from 0° first.</source>
        <translation>走到路径的 {gone} % 处为奇异位姿：关节 {joint} 将发生跳变。请改用 MOVE P，或先把关节 5 转离 0°。</translation>
    </message>
    <message>
        <source>The arm stands {distance} mm and {turned}° away from the start of the arc. Press Go to start first.</source>
        <translation>机械臂距圆弧起点 {distance} mm、{turned}°。请先按“移到起点”。</translation>
    </message>
    <message>
        <source>The three poses lie on a line, or two in one place: that is no arc. Capture others.</source>
        <translation>三个位姿在一条直线上，或有两个重合，不构成圆弧。请重新记录。</translation>
    </message>
    <message>
        <source>Not captured yet: {point}. Bring the arm there and press its button.</source>
        <translation>尚未记录：{point}。请把机械臂移到该处并按对应按钮。</translation>
    </message>
    <message>
        <source>The pose the arm reports does not fit its joint angles: the program cannot compute its way. Check the joints&apos; zeros; the joints can still be moved one by one.</source>
        <translation>机械臂上报的位姿与关节角度不符，程序无法计算路径。请检查各关节零点；仍可单独移动各关节。</translation>
    </message>
    <message>
        <source>Tool centre point: {value} is not possible. Enter lengths up to {maximum} mm and angles up to 180°.</source>
        <translation>工具中心点：不能为 {value}。长度不超过 {maximum} mm，角度不超过 180°。</translation>
    </message>
    <message>
        <source>{light}: {value} is out of range. Enter a whole number from {minimum} to {maximum}.</source>
        <translation>{light}：{value} 超出范围。请输入 {minimum} 至 {maximum} 的整数。</translation>
    </message>
    <message>
        <source>{light}: “{value}” is not a whole number. Enter one from {minimum} to {maximum}.</source>
        <translation>{light}：“{value}”不是整数。请输入 {minimum} 至 {maximum} 的整数。</translation>
    </message>
    <message>
        <source>No end load is chosen. Choose one first.</source>
        <translation>尚未选择末端负载，请先选择。</translation>
    </message>
    <message>
        <source>The arm is moving. Wait until it stands still, then set the end load.</source>
        <translation>机械臂正在运动，请待其静止后再设置末端负载。</translation>
    </message>
    <message>
        <source>The arm has answered, but goes on reporting. Try again.</source>
        <translation>机械臂已应答，但仍在上报，请重试。</translation>
    </message>
    <message>
        <source>An offset of {value} is not possible. Choose 0x00, 0x10 or 0x20.</source>
        <translation>偏移值不能为 {value}，请选择 0x00、0x10 或 0x20。</translation>
    </message>
    <message>
        <source>The arm is moving. Wait until it stands still, then set the linkage.</source>
        <translation>机械臂正在运动，请待其静止后再设置联动。</translation>
    </message>
    <message>
        <source>No gripper is heard. If one is mounted, check its cable and its power.</source>
        <translation>未收到夹爪反馈。若已安装夹爪，请检查其线缆和供电。</translation>
    </message>
    <message>
        <source>The gripper of a generation 1 arm has no command for its zero.</source>
        <translation>第 1 代机械臂的夹爪没有零点设置指令。</translation>
    </message>
    <message>
        <source>{gripper}: {value} {unit} is out of range. Enter a value from {minimum} to {maximum} {unit}.</source>
        <translation>{gripper}：{value} {unit} 超出范围，请输入 {minimum} 至 {maximum} {unit} 之间的值。</translation>
    </message>
    <message>
        <source>{gripper}: “{value}” is not a number. Enter a value from {minimum} to {maximum} {unit}.</source>
        <translation>{gripper}：“{value}”不是数字，请输入 {minimum} 至 {maximum} {unit} 之间的值。</translation>
    </message>
    <message>
        <source>Whether these joints stand still is not known: {joints}. Their drivers report no speed: check the arm&apos;s power and the CAN cable.</source>
        <translation>无法确认以下关节是否静止：{joints}。其驱动器未上报速度，请检查机械臂电源和 CAN 线缆。</translation>
    </message>
    <message>
        <source>These joints are moving: {joints}. Wait until the arm stands still.</source>
        <translation>以下关节正在运动：{joints}。请等待机械臂静止。</translation>
    </message>
    <message>
        <source>The arm answered that it did not set the zero of these joints: {joints}. Let the arm stand still, clear its errors, then try again.</source>
        <translation>机械臂应答：以下关节的零点未设置成功：{joints}。请让机械臂静止并清除错误后重试。</translation>
    </message>
    <message>
        <source>The arm answered that the zero is set, but these joints do not read 0°: {joints}. Do not move the arm before the zero is set anew.</source>
        <translation>机械臂应答零点已设置，但以下关节的角度不为 0°：{joints}。重新设置零点之前请勿移动机械臂。</translation>
    </message>
    <message>
        <source>The stop came first; this is not sent again. Check the state of the arm, then repeat it.</source>
        <translation>急停在先，该指令不会重发。请查看机械臂的状态后再操作。</translation>
    </message>
    <message>
        <source>{device} is not there. Check that it is plugged in and its cable is sound.</source>
        <translation>找不到设备 {device}。请检查设备是否插好、线缆是否完好。</translation>
    </message>
    <message>
        <source>{device} is in use by another program. Close that program, then connect again.</source>
        <translation>设备 {device} 正被其他程序占用。请关闭该程序后重新连接。</translation>
    </message>
    <message>
        <source>{device} is switched off in the system. Switch it on in a terminal (with your interface&apos;s name for can0): sudo ip link set can0 up type can bitrate 1000000</source>
        <translation>设备 {device} 在系统中未启用。请在终端中启用（将 can0 换成实际的接口名）：sudo ip link set can0 up type can bitrate 1000000</translation>
    </message>
    <message>
        <source>You may not open {device}. On Linux add your account to the group dialout (serial adapters) or install the adapter&apos;s udev rule (USB adapters), then log in again.</source>
        <translation>没有权限打开设备 {device}。Linux 下：串口适配器请将当前用户加入 dialout 组，USB 适配器请安装其 udev 规则，然后重新登录。</translation>
    </message>
    <message>
        <source>{device} needs a Python package that is not installed. Install it in a terminal: pip install {package}</source>
        <translation>设备 {device} 需要的 Python 软件包尚未安装。请在终端中安装：pip install {package}</translation>
    </message>
    <message>
        <source>The driver for {device} ({interface}) is missing. Install the driver of the adapter&apos;s maker; for socketcan load the kernel&apos;s modules: sudo modprobe can_raw</source>
        <translation>缺少设备 {device}（{interface}）的驱动。请安装适配器厂家的驱动；使用 socketcan 时请加载内核模块：sudo modprobe can_raw</translation>
    </message>
    <message>
        <source>{device} does not accept these settings: {text}. Check interface, channel and bit rate.</source>
        <translation>设备 {device} 不接受这些参数：{text}。请检查接口、通道和波特率。</translation>
    </message>
    <message>
        <source>{device} could not be opened: {text}. Check the device and its driver, then connect again.</source>
        <translation>无法打开设备 {device}：{text}。请检查设备及其驱动，然后重新连接。</translation>
    </message>
    <message>
        <source>The settings file could not be read and was put aside as {kept}. The program starts with default settings.</source>
        <translation>设置文件无法读取，已另存为 {kept}。程序以默认设置启动。</translation>
    </message>
    <message>
        <source>The settings file {path} could not be read: {text}. The program starts with default settings.</source>
        <translation>设置文件 {path} 无法读取：{text}。程序以默认设置启动。</translation>
    </message>
    <message>
        <source>The settings could not be saved in {path}: {text}. They hold until the program ends.</source>
        <translation>设置无法保存到 {path}：{text}。本次运行期间仍然有效。</translation>
    </message>
    <message>
        <source>Setting “{field}”: “{value}” is not valid. The default is used instead.</source>
        <translation>设置项“{field}”：“{value}”无效，已使用默认值。</translation>
    </message>
    <message>
        <source>Jog step {value}° is out of range. Enter a value from {minimum}° to {maximum}°.</source>
        <translation>点动步长 {value}° 超出范围。请输入 {minimum}° 至 {maximum}°。</translation>
    </message>
    <message>
        <source>Jog step: “{value}” is not an angle. Enter a number of degrees, for example 0.5.</source>
        <translation>点动步长：“{value}”不是角度。请输入以度为单位的数字，例如 0.5。</translation>
    </message>
    <message>
        <source>The three points lie nearly in line: the third is {value}° off the X axis, at least {minimum}° are needed. Take the point on the +Y side again, further to the side.</source>
        <translation>三点几乎共线：第三点偏离 X 轴只有 {value}°，至少需要 {minimum}°。请在 +Y 一侧更偏的位置重新采集该点。</translation>
    </message>
    <message>
        <source>{figure}: “{value}” is not a number. Enter a value from {minimum} to {maximum} {unit}.</source>
        <translation>{figure}：“{value}”不是数字，请输入 {minimum} 至 {maximum} {unit} 之间的值。</translation>
    </message>
    <message>
        <source>{figure}: {value} {unit} is out of range. Enter a value from {minimum} to {maximum} {unit}.</source>
        <translation>{figure}：{value} {unit} 超出范围，请输入 {minimum} 至 {maximum} {unit} 之间的值。</translation>
    </message>
    <message>
        <source>{figure}: “{value}” is not a whole number. Enter one from {minimum} to {maximum}.</source>
        <translation>{figure}：“{value}”不是整数。请输入 {minimum} 至 {maximum} 的整数。</translation>
    </message>
    <message>
        <source>{figure}: {value} is out of range. Enter a whole number from {minimum} to {maximum}.</source>
        <translation>{figure}：{value} 超出范围。请输入 {minimum} 至 {maximum} 的整数。</translation>
    </message>
    <message>
        <source>Outside the limits: {joints}. Until all are inside the arm takes only a run, or a target with all joints inside. Hold Move inside in the line above the panels.</source>
        <translation>位于限位之外：{joints}。全部回到限位内之前，机械臂只接受轨迹运行或各关节均在限位内的目标。请按住面板上方提示行中的“回到限位内”。</translation>
    </message>
    <message>
        <source>Joint {joint}: {value}° is beyond its limits of {minimum}° to {maximum}°. Enter an angle within them.</source>
        <translation>关节 {joint}：{value}° 超出限位 {minimum}° 至 {maximum}°。请输入限位以内的角度。</translation>
    </message>
    <message>
        <source>The process of the simulated arm has ended. One that was connected is started anew by itself, as after a power cut; otherwise connect again.</source>
        <translation>仿真机械臂的进程已结束。已连接的会自动重新启动，如同断电后上电；否则请重新连接。</translation>
    </message>
    <message>
        <source>{device} is deaf: it has sent {count} frames, heard none, and reports no error. Unplug the adapter and plug it in again. If that does not help, check CAN_H and CAN_L, the bit rate, the terminating resistors (120 Ω), a receive filter of the adapter, and the arm&apos;s power.</source>
        <translation>{device} 收不到任何帧：已发送 {count} 帧，一帧也没听到，也不报错误。请拔下适配器再插上；若仍不行，请检查 CAN_H 和 CAN_L、波特率、终端电阻（120 Ω）、适配器的接收过滤器和机械臂的电源。</translation>
    </message>
    <message>
        <source>The cell&apos;s file is broken or cut short: line {line}, column {column} is not JSON. Nothing was changed; choose another file, or correct that line.</source>
        <translation>单元文件损坏或不完整：第 {line} 行第 {column} 列不是 JSON。未作任何更改；请选择另一个文件，或改正该行。</translation>
    </message>
    <message>
        <source>This is no cell of this program. Nothing was changed; choose another file.</source>
        <translation>这不是本程序的单元文件。未作任何更改；请选择另一个文件。</translation>
    </message>
    <message>
        <source>The cell&apos;s file is not valid at “{field}” ({problem}). Nothing was changed; choose another file, or correct the field.</source>
        <translation>单元文件在“{field}”处无效（{problem}）。未作任何更改；请选择另一个文件，或改正该字段。</translation>
    </message>
    <message>
        <source>The arm was moving when it was first heard, and not by a command of this connection. Wait until it rests, or press Halt (F9).</source>
        <translation>开始收到机械臂反馈时，它已在运动，且不是本次连接发出的指令。请等它静止，或按停住（F9）。</translation>
    </message>
    <message>
        <source>This adapter was last used with the cell “{name}”, and the gripper held “{held}”. Confirm both if they are there; if the gripper is empty, let go under Cell, Held first.</source>
        <translation>此适配器上次使用的单元是“{name}”，夹爪夹着“{held}”。两者都属实请确认；如夹爪是空的，请先在“单元”的“工件”中标为“已放下”。</translation>
    </message>
    <message>
        <source>The arm was silent or exchanged meanwhile, and may be another one: the points taken before were dropped. Take them anew.</source>
        <translation>机械臂其间没有反馈或被更换，可能已是另一台：之前记录的点已丢弃。请重新记录。</translation>
    </message>
    <message>
        <source>The arm is not in emergency stop: there is nothing to release.</source>
        <translation>机械臂不在急停状态，无需解除。</translation>
    </message>
    <message>
        <source>No user frame is in force, or another one than at the press. Choose one under Cell, then press again; or move along base or tool.</source>
        <translation>没有生效的用户坐标系，或已不是按下时的那个。请在“单元”中选择坐标系后再按，或沿基坐标系、工具坐标系移动。</translation>
    </message>
    <message>
        <source>No joint lies outside its limits: there is no way back to go.</source>
        <translation>没有关节位于限位之外：无需返回。</translation>
    </message>
    <message>
        <source>The CAN device took no frame within a second of the press. Check the CAN cable and the arm&apos;s power, then try again.</source>
        <translation>按下后 1 秒内 CAN 设备没有发出任何帧。请检查 CAN 线缆和机械臂电源，然后重试。</translation>
    </message>
    <message>
        <source>How far each joint may swing is not worked out yet for where the arm stands. Wait a moment, with the arm at rest.</source>
        <translation>当前位置各关节可摆动的范围还没有算出。请让机械臂静止，稍等片刻。</translation>
    </message>
    <message>
        <source>No joint may swing over 10° here. Bring the arm to a place with room around it.</source>
        <translation>这里没有关节能摆动 10°。请把机械臂移到周围有空间的位置。</translation>
    </message>
    <message>
        <source>It may swing over less than 10° here.</source>
        <translation>在这里可摆动不足 10°。</translation>
    </message>
    <message>
        <source>Too little of its swing was heard, or the speed was changed meanwhile.</source>
        <translation>其摆动的反馈太少，或途中速度被改变。</translation>
    </message>
    <message>
        <source>The inspection ended before its turn was over.</source>
        <translation>轮到它摆完之前巡检已结束。</translation>
    </message>
    <message>
        <source>The speed is 0 %: raise it at the top, then hold “Continue” for 1 s.</source>
        <translation>速度为 0 %：请先在顶栏调高，再按住“继续”1 秒。</translation>
    </message>
    <message>
        <source>At the recorded pace joint {joint} would turn at {value}°/s; its limit is {maximum}°/s. This replay goes at {percent} % at most.</source>
        <translation>按录制速度，关节 {joint} 会以 {value}°/s 转动，其上限为 {maximum}°/s。本次回放最高 {percent} %。</translation>
    </message>
    <message>
        <source>Nothing was sent: a second after the press the arm did not rest yet, or its way was still being checked. Press again.</source>
        <translation>未发送：按下一秒后机械臂仍未静止，或路径仍在检查。请再按一次。</translation>
    </message>
    <message>
        <source>Nothing was sent: while its way was checked the arm moved, or what it was checked against has changed. Press again.</source>
        <translation>未发送：检查路径期间机械臂移动了，或检查所依据的内容已改变。请再按一次。</translation>
    </message>
    <message>
        <source>This frame ends an emergency stop and lets the arm drop. Use Release in the main window, once the arm is supported.</source>
        <translation>该帧会解除急停并使机械臂坠落。请先托住机械臂，再使用主窗口中的“解除急停”。</translation>
    </message>
    <message>
        <source>The arm is in emergency stop. Support it, hold Release above the panel, then enable the motors.</source>
        <translation>机械臂处于急停状态。请扶住机械臂，按住面板上方的“解除急停”，然后使能电机。</translation>
    </message>
    <message>
        <source>Not all of the arm&apos;s joint angles are heard now. Wait until all six are shown, none muted.</source>
        <translation>现在没有收到全部关节角度。请等待 6 个关节的角度都显示出来且不变灰。</translation>
    </message>
    <message>
        <source>No log is being written, in which an episode could be marked. Start a log.</source>
        <translation>现在没有在写日志，无处标记片段。请先开始日志。</translation>
    </message>
    <message>
        <source>An episode is under way already. End it first.</source>
        <translation>已有片段在进行。请先结束它。</translation>
    </message>
    <message>
        <source>No episode is under way. Begin one first.</source>
        <translation>没有进行中的片段。请先开始一个。</translation>
    </message>
    <message>
        <source>There is no episode to discard: none was begun, or the last one is discarded.</source>
        <translation>没有可弃用的片段：还没有开始过，或最后一个已弃用。</translation>
    </message>
    <message>
        <source>A task is one line of text, of {maximum} characters at most.</source>
        <translation>任务是一行文字，最多 {maximum} 个字符。</translation>
    </message>
    <message>
        <source>The log has {maximum} episodes already. Stop it and start another one.</source>
        <translation>这份日志已有 {maximum} 个片段。请停止它，再开始一份。</translation>
    </message>
    <message>
        <source>The local interface is offered on Linux only, for now.</source>
        <translation>本地接口目前仅在 Linux 上提供。</translation>
    </message>
    <message>
        <source>Another armui of yours serves {path} already. Switch its interface off, or close it.</source>
        <translation>您的另一个 armui 已在 {path} 提供服务。请关闭它的接口，或关闭它。</translation>
    </message>
    <message>
        <source>The operator did not hold the button within {seconds} s.</source>
        <translation>操作员在 {seconds} s 内没有按住按钮。</translation>
    </message>
    <message>
        <source>The operator is being asked about something else of yours. Wait for that.</source>
        <translation>正在就您的另一件事询问操作员。请等待。</translation>
    </message>
    <message>
        <source>“{client}” asks for the arm, or holds it. Wait until it is free, or have the operator take it back.</source>
        <translation>“{client}”正在申请或持有机械臂。请等它释放，或由操作员收回。</translation>
    </message>
    <message>
        <source>{device} is bus off: too many errors on the CAN bus, so its controller takes no part any more. Check CAN_H and CAN_L, both terminating resistors (120 Ω) and the bit rate, then disconnect and connect again; on socketcan run “sudo ip link set {channel} type can restart” before.</source>
        <translation>{device} 处于总线关闭（bus off）：CAN 总线错误过多，其控制器已退出总线。请检查 CAN_H、CAN_L、两端 120 Ω 终端电阻和波特率，然后断开并重新连接；socketcan 请先执行 sudo ip link set {channel} type can restart。</translation>
    </message>
    <message>
        <source>The arm is too near to “{name}” of the work area: {part}, by {value} mm; this would bring it nearer still. Move it away.</source>
        <translation>机械臂离工作区的“{name}”过近：{part}，差 {value} mm；这样会更近。请移开。</translation>
    </message>
    <message>
        <source>The gripper is moving. Wait until it stands still, then press again.</source>
        <translation>夹爪仍在运动。请等它停稳后再按。</translation>
    </message>
    <message>
        <source>The gripper was disabled while it ran: the arm was told to end its motion. See what it held.</source>
        <translation>运行中夹爪被失能，已令机械臂结束运动。请检查所夹工件。</translation>
    </message>
    <message>
        <source>Motors were disabled while it ran: the arm was told to end its motion.</source>
        <translation>运行中电机被失能，已令机械臂结束运动。</translation>
    </message>
    <message>
        <source>This is a log that is replayed: nothing can be sent. Whatever is to reach an arm is done in the main window.</source>
        <translation>这是正在回放的日志，不能发送任何指令。要操作机械臂，请回到主窗口。</translation>
    </message>
    <message>
        <source>It was the emergency stop.</source>
        <translation>原因是急停。</translation>
    </message>
    <message>
        <source>The arm reports no pose now. Wait until all six values are shown, none muted.</source>
        <translation>现在收不到机械臂的末端位姿。请等六个数值全部显示且不变灰。</translation>
    </message>
    <message>
        <source>The program was held up for {value} ms, which ended the stream. The next target begins another.</source>
        <translation>程序停顿了 {value} 毫秒，目标流因此结束。发送下一个目标即开始新的目标流。</translation>
    </message>
    <message>
        <source>To this pose joint {joint} would turn by {value}°, more than {maximum}° at once: the arm would change its posture. Send poses nearer to one another.</source>
        <translation>到此位姿关节 {joint} 需一次转动 {value}°，超过 {maximum}°：机械臂会改变构型。请发送彼此更接近的位姿。</translation>
    </message>
    <message>
        <source>The arm says that it is there, but measures itself away from the point: {away}. See what keeps it.</source>
        <translation>机械臂报告已到达，但测量值与目标相差 {away}，请检查原因。</translation>
    </message>
    <message>
        <source>The program, the computer or the adapter stood still for {seconds} s, so the run was ended. Let the computer do less beside it, keep it from sleeping, and start it anew.</source>
        <translation>程序、计算机或适配器停顿了 {seconds} 秒，运行已结束。请减少计算机的其他任务并禁止休眠，然后重新开始。</translation>
    </message>
    <message>
        <source>The point was not reached within {seconds} s. See what keeps the arm.</source>
        <translation>{seconds} 秒内未到达该点，请检查机械臂受阻原因。</translation>
    </message>
    <message>
        <source>No point of “{name}” is saved, and what is not saved does not run. Open it and save it.</source>
        <translation>“{name}”没有已保存的轨迹点，未保存的内容不能执行。请打开并保存。</translation>
    </message>
    <message>
        <source>The arm would come some {value} mm below the floor. Go there only if nothing is there. With a lowest height chosen under Settings this is not asked each time.</source>
        <translation>机械臂将低至地面以下约 {value} mm。确认那里没有物体后才可前往。在“设置”中选定最低高度后，不再逐次询问。</translation>
    </message>
    <message>
        <source>The arm reports: {status}. The line above the panels says what helps.</source>
        <translation>机械臂报告：{status}。面板上方的提示行给出处理办法。</translation>
    </message>
    <message>
        <source>Look for the reason, and begin the next one slowly. Joint {joint} moves at {value}°/s. {percent} % was told, that is {maximum}°/s at most; above {limit}°/s a motion is ended.</source>
        <translation>请查明原因，下次运动以低速开始。关节 {joint} 实测 {value}°/s；下达的 {percent} % 对应最高 {maximum}°/s，超过 {limit}°/s 即结束运动。</translation>
    </message>
    <message>
        <source>Look for the reason, and begin the next one slowly. The tool moves at {value} mm/s. {percent} % was told, that is {maximum} mm/s at most on this path; above {limit} mm/s a motion is ended.</source>
        <translation>请查明原因，下次运动以低速开始。工具移动实测 {value} mm/s；下达的 {percent} % 在此路径上对应最高 {maximum} mm/s，超过 {limit} mm/s 即结束运动。</translation>
    </message>
    <message>
        <source>Look for the reason, and begin the next one slowly. The tool turns at {value}°/s. {percent} % was told, that is {maximum}°/s at most on this path; above {limit}°/s a motion is ended.</source>
        <translation>请查明原因，下次运动以低速开始。工具转动实测 {value}°/s；下达的 {percent} % 在此路径上对应最高 {maximum}°/s，超过 {limit}°/s 即结束运动。</translation>
    </message>
    <message>
        <source>The arm has answered, but the fault is still there.</source>
        <translation>机械臂已应答，但故障仍在。</translation>
    </message>
    <message>
        <source>“{name}” cannot be the name of a log. Leave out / \ : * ? &quot; &lt; &gt; | and a dot at the beginning or the end; 120 characters at most.</source>
        <translation>“{name}”不能作为日志的名称。请勿使用 / \ : * ? &quot; &lt; &gt; |，首尾不能是句点，最多 120 个字符。</translation>
    </message>
    <message>
        <source>This needs the lease of the arm. Ask for it with lease.request, and name its number.</source>
        <translation>这需要机械臂的租约。请用 lease.request 申请，并注明其编号。</translation>
    </message>
    <message>
        <source>The operator did not grant the arm within {seconds} s. Ask again when somebody is there.</source>
        <translation>操作员在 {seconds} s 内没有授予机械臂。有人在场时请再申请。</translation>
    </message>
    <message>
        <source>The operator has declined.</source>
        <translation>操作员已拒绝。</translation>
    </message>
    <message>
        <source>The client has released the arm.</source>
        <translation>客户端已释放机械臂。</translation>
    </message>
    <message>
        <source>The operator has taken the arm back.</source>
        <translation>操作员已收回机械臂。</translation>
    </message>
    <message>
        <source>The operator has moved the arm himself ({operation}).</source>
        <translation>操作员自己操作了机械臂（{operation}）。</translation>
    </message>
    <message>
        <source>The arm was stopped or halted.</source>
        <translation>机械臂已急停或停住。</translation>
    </message>
    <message>
        <source>Nothing was heard from the client for {seconds} s. It must say so more often.</source>
        <translation>{seconds} s 内没有收到客户端的消息。它必须更频繁地发送消息。</translation>
    </message>
    <message>
        <source>The client has closed its connection.</source>
        <translation>客户端已关闭连接。</translation>
    </message>
    <message>
        <source>The arm is not heard, or another arm or connection has come.</source>
        <translation>收不到机械臂的反馈，或换了另一台机械臂或连接。</translation>
    </message>
    <message>
        <source>Somebody else moves the arm.</source>
        <translation>另有一方在运动机械臂。</translation>
    </message>
    <message>
        <source>The arm reports a fault.</source>
        <translation>机械臂报告故障。</translation>
    </message>
    <message>
        <source>The interface or the program ends.</source>
        <translation>接口或程序已结束。</translation>
    </message>
    <message>
        <source>This lease was asked for without motions. Ask for one with “moves”.</source>
        <translation>此租约申请时不含运动。请申请带“moves”的租约。</translation>
    </message>
    <message>
        <source>The client has called the run off.</source>
        <translation>客户端已取消此次运行。</translation>
    </message>
    <message>
        <source>“{name}” has {count} points or samples; a program may have {maximum} checked and run. Have the operator run it.</source>
        <translation>“{name}”有 {count} 个点或采样；程序最多可检查和运行 {maximum} 个。请由操作员运行。</translation>
    </message>
    <message>
        <source>Something else is being checked for you. Wait for its answer.</source>
        <translation>正在为您检查另一条轨迹。请等待其结果。</translation>
    </message>
    <message>
        <source>Another program has port {port}: the live stream is not served. Choose another port in the settings, or end that program and switch the stream off and on.</source>
        <translation>端口 {port} 被其他程序占用，实时数据流未提供。请在设置中另选端口，或结束该程序后关闭再打开数据流。</translation>
    </message>
    <message>
        <source>The process of the live stream has ended by itself. Switch it off and on.</source>
        <translation>实时数据流的进程自行结束了。请关闭再打开。</translation>
    </message>
    <message>
        <source>The log has no times: its frames stand 1 ms apart in their order. No time in it is measured, nor any speed.</source>
        <translation>日志中没有时间：各帧按顺序每隔 1 ms 排列。其中的时间和速度都不是测得的。</translation>
    </message>
    <message>
        <source>Its times are those since the frame before: they were added up.</source>
        <translation>日志中的时间是与前一帧的间隔：已逐帧累加。</translation>
    </message>
    <message>
        <source>Its times are in {unit}, and read as such.</source>
        <translation>日志中的时间以 {unit} 为单位，已按此读取。</translation>
    </message>
    <message>
        <source>Its last line breaks off and is left out, as where a recorder is ended.</source>
        <translation>最后一行不完整，已略去；记录程序被结束时常会如此。</translation>
    </message>
    <message>
        <source>No episode is marked in it: all of it is taken as one, “{task}”.</source>
        <translation>其中没有标记片段：整个日志作为一个片段“{task}”。</translation>
    </message>
    <message>
        <source>Left out, {begin} s to {end} s: the angles were not heard, or older than 0.1 s. What follows is an episode of its own.</source>
        <translation>略去 {begin} s 至 {end} s：未收到关节角度，或已超过 0.1 s。其后另成一个片段。</translation>
    </message>
    <message>
        <source>Left out, {begin} s to {end} s: the arm told a stop or a fault. What follows is an episode of its own.</source>
        <translation>略去 {begin} s 至 {end} s：机械臂报告急停或故障。其后另成一个片段。</translation>
    </message>
    <message>
        <source>Left out, {begin} s to {end} s: the gripper was not heard. What follows is an episode of its own.</source>
        <translation>略去 {begin} s 至 {end} s：未收到夹爪反馈。其后另成一个片段。</translation>
    </message>
    <message>
        <source>Left out, {begin} s to {end} s: shorter than an episode of 1 s.</source>
        <translation>略去 {begin} s 至 {end} s：不足一个片段的 1 s。</translation>
    </message>
    <message>
        <source>{count} more stretches were left out.</source>
        <translation>另有 {count} 段被略去。</translation>
    </message>
    <message>
        <source>In {count} of {all} frames no host had told the joints where to go: their action is where the arm was.</source>
        <translation>{all} 帧中有 {count} 帧没有主机给出关节目标：其动作取机械臂所在位置。</translation>
    </message>
    <message>
        <source>{name} is an MF4 file, and those are not read. Convert it to .asc or .blf with other software, for example asammdf, and open what that has written.</source>
        <translation>{name} 是 MF4 文件，本程序不读取这种文件。请用其他软件（例如 asammdf）将其转换为 .asc 或 .blf，再打开转换后的文件。</translation>
    </message>
    <message>
        <source>The log could not be written in {folder}: {text}. What was written before can be read. Choose another folder, or try again.</source>
        <translation>无法在 {folder} 中写入日志：{text}。此前写入的内容可以读取。请选择其他文件夹，或重试。</translation>
    </message>
    <message>
        <source>Setting “{field}”: {count} of its entries cannot be read, the first is “{key}”: “{value}”. The others hold; these stay in the file until you choose anew.</source>
        <translation>设置项“{field}”：有 {count} 个条目无法读取，第一个是“{key}”：“{value}”。其余条目有效；这些条目保留在文件中，直到重新选择。</translation>
    </message>
    <message>
        <source>The settings file could not be read any more and was put aside as {kept}. The present settings hold, and are saved with the next change.</source>
        <translation>设置文件已无法读取，已另存为 {kept}。当前设置仍然有效，将在下次更改时保存。</translation>
    </message>
    <message>
        <source>This file of another program has no plain list of places. Write each place as a row of a CSV file with the titles time_s, joint1_rad … joint6_rad, gripper_m (or joint1_deg …, gripper_mm), and import that.</source>
        <translation>这是其他程序的文件，其中没有可直接读取的点位列表。请把每个点位写成 CSV 文件的一行，列标题为 time_s、joint1_rad … joint6_rad、gripper_m（或 joint1_deg …、gripper_mm），再导入该文件。</translation>
    </message>
    <message>
        <source>This file holds commands that only another program knows: {text}. Write each place as a row of a CSV file with the titles joint1_rad … joint6_rad (or joint1_deg …), dwell_s, and import that.</source>
        <translation>文件中含有只有其他程序才懂的指令：{text}。请把每个点位写成 CSV 文件的一行，列标题为 joint1_rad … joint6_rad（或 joint1_deg …）、dwell_s，再导入该文件。</translation>
    </message>
    <message>
        <source>The titles of the poses and the row “#tool” belong together: titles with tcp_ are of the tool in that row, those without are of the flange. Export the file again.</source>
        <translation>位姿的列标题与“#tool”行须一致：带 tcp_ 的标题是该行工具的位姿，不带的是法兰的位姿。请重新导出该文件。</translation>
    </message>
    <message>
        <source>“{value}” is not an option of a point; use frame, speed, dwell, gripper, holds, light or note.</source>
        <translation>“{value}”不是有效的点选项，可用选项为 frame、speed、dwell、gripper、holds、light 和 note。</translation>
    </message>
    <message>
        <source>A folder needs a name. Enter one.</source>
        <translation>文件夹需要名称。请输入。</translation>
    </message>
    <message>
        <source>There is a “{name}” in the library&apos;s folder already. Choose another name.</source>
        <translation>轨迹库的文件夹中已有“{name}”。请换一个名称。</translation>
    </message>
    <message>
        <source>Not every system takes a folder called “{name}”. “{fitting}” would do.</source>
        <translation>并非所有系统都允许文件夹名为“{name}”。可用“{fitting}”。</translation>
    </message>
    <message>
        <source>The folder “{name}” is not in the library any more. It was renamed, moved or deleted elsewhere.</source>
        <translation>文件夹“{name}”已不在轨迹库中。它在别处被改名、移动或删除。</translation>
    </message>
    <message>
        <source>The folder “{name}” is not empty and is kept: {held}. Move or delete what is in it first.</source>
        <translation>文件夹“{name}”不是空的，已保留：{held}。请先移走或删除其中的内容。</translation>
    </message>
    <message>
        <source>Not done: {name}: {text}. Check the rights to the library&apos;s folder.</source>
        <translation>未执行：{name}：{text}。请检查轨迹库文件夹的访问权限。</translation>
    </message>
    <message>
        <source>{file} has poses of the tool “{name}”, which the cell does not have. The flange goes where it did there; the table shows the figures of the tool in force.</source>
        <translation>{file} 中是工具“{name}”的位姿，而单元中没有该工具。法兰仍去文件中的位置；表中显示的是当前生效工具的数值。</translation>
    </message>
    <message>
        <source>{file} has poses of the tool “{name}”, whose figures are others here. The flange goes where it did there, the tip elsewhere.</source>
        <translation>{file} 中是工具“{name}”的位姿，而该工具在这里的数值不同。法兰仍去文件中的位置，工具尖端则到别处。</translation>
    </message>
    <message>
        <source>{file} has points in the user frame “{name}”, which the cell does not have. They do not run until it is there, or they are given another frame.</source>
        <translation>{file} 中有点属于用户坐标系“{name}”，而单元中没有该坐标系。补上它，或为这些点改用其他坐标系之前，不能运行。</translation>
    </message>
    <message>
        <source>{file} has points in the user frame “{name}”, which stands elsewhere here, by {distance} mm and {turned}°. The points go with it.</source>
        <translation>{file} 中有点属于用户坐标系“{name}”，而它在这里的位置不同，相差 {distance} mm、{turned}°。这些点随坐标系移动。</translation>
    </message>
    <message>
        <source>The arm does not reach X {x}  Y {y}  Z {z} mm with this orientation: no joint angles belong to it. Change the pose.</source>
        <translation>机械臂以此姿态到不了 X {x}  Y {y}  Z {z} mm：没有对应的关节角度。请更改位姿。</translation>
    </message>
    <message>
        <source>Joint angles belong to no frame, and this point names “{name}”. Make it MOVE P, L or C, or take the frame away.</source>
        <translation>关节角度不属于任何坐标系，但该点写明了坐标系“{name}”。请改为 MOVE P、L 或 C，或去掉坐标系。</translation>
    </message>
    <message>
        <source>What the question was about has changed: nothing was done. Try again.</source>
        <translation>所询问的情况已经改变：未执行任何操作。请重新操作。</translation>
    </message>
    <message>
        <source>No park position is kept for this arm. Set it with the arrow beside.</source>
        <translation>尚未为此机械臂设定停放位。请用旁边的箭头设定。</translation>
    </message>
    <message>
        <source>These poses are of a tool, and none is in force. Choose that tool under Cell, then paste again.</source>
        <translation>这些位姿属于某个工具，而当前没有生效的工具。请先在“单元”中选择该工具，再粘贴。</translation>
    </message>
    <message>
        <source>The program is still working on many rows. Wait until it is done.</source>
        <translation>程序仍在处理多行点位，请等它完成。</translation>
    </message>
    <message>
        <source>The points were changed while the program worked on them. Try again.</source>
        <translation>处理期间点位已被改动，本次操作未执行。请重试。</translation>
    </message>
    <message>
        <source>Not run: the check has found errors ({count}). Correct what is listed, then press Run again.</source>
        <translation>未运行：检查发现 {count} 个错误。请处理列出的各项，再次点击发送。</translation>
    </message>
    <message>
        <source>Robot description: the file {path} is not there. Choose another file, or use the built-in one.</source>
        <translation>机器人模型：找不到文件 {path}。请选择其他文件，或使用内置模型。</translation>
    </message>
    <message>
        <source>Robot description: the file {path} cannot be read: {text}. Choose a file you may read.</source>
        <translation>机器人模型：无法读取文件 {path}：{text}。请选择有权读取的文件。</translation>
    </message>
    <message>
        <source>Robot description: {path} is not well-formed XML ({text}). Repair or export it again.</source>
        <translation>机器人模型：{path} 不是格式正确的 XML（{text}）。请修复该文件或重新导出。</translation>
    </message>
    <message>
        <source>Robot description: {path} describes no robot: its first element is “{element}”, not “robot”. Choose a URDF file.</source>
        <translation>机器人模型：{path} 不是机器人描述：其首个元素是“{element}”，而不是“robot”。请选择 URDF 文件。</translation>
    </message>
    <message>
        <source>Robot description: {path} is written in words of xacro ({word}), which ROS expands. Expand it with “xacro {path} &gt; {expanded}” where ROS is installed, and choose {expanded}.</source>
        <translation>机器人模型：{path} 用 xacro 语句（{word}）写成，须由 ROS 展开。请在装有 ROS 的计算机上运行“xacro {path} &gt; {expanded}”，然后选择 {expanded}。</translation>
    </message>
    <message>
        <source>Robot description: {path} is not written as URDF demands: {text}. Correct it.</source>
        <translation>机器人模型：{path} 不符合 URDF 的写法：{text}。请更正。</translation>
    </message>
    <message>
        <source>Robot description: in {path} an element or attribute is missing that URDF demands. Check that every link, joint and visual is complete.</source>
        <translation>机器人模型：{path} 缺少 URDF 要求的元素或属性。请检查每个 link、joint 和 visual 是否完整。</translation>
    </message>
    <message>
        <source>Robot description: in {path} these links do not hang together as one tree: {links}. Every link but the first needs exactly one joint that carries it.</source>
        <translation>机器人模型：{path} 中的这些连杆没有连成一棵树：{links}。除首个连杆外，每个连杆都需要且只需要一个承载它的关节。</translation>
    </message>
    <message>
        <source>Robot description: joint “{joint}” in {path} is wrong. It needs a name of its own, a type and an axis that URDF knows and, if it mimics, a joint to mimic.</source>
        <translation>机器人模型：{path} 中的关节“{joint}”有误。它需要唯一的名称、URDF 认可的类型和轴；若为从动关节（mimic），还需要所跟随的关节。</translation>
    </message>
    <message>
        <source>Robot description: {path} has {found} revolute joints in a row instead of {wanted}. Choose the description of a six-joint arm.</source>
        <translation>机器人模型：{path} 中连续的旋转关节有 {found} 个，而不是 {wanted} 个。请选择六轴机械臂的描述文件。</translation>
    </message>
    <message>
        <source>Robot description: the mesh “{mesh}” that {path} names is not there. Put it where the file says, or correct its name in the file.</source>
        <translation>机器人模型：找不到 {path} 所指的网格文件“{mesh}”。请把它放到该文件所写的位置，或更正文件中的名称。</translation>
    </message>
    <message>
        <source>Robot description: the mesh {mesh} cannot be read: {text}. Export it again.</source>
        <translation>机器人模型：无法读取网格文件 {mesh}：{text}。请重新导出。</translation>
    </message>
    <message>
        <source>Robot description: the mesh {mesh} holds no surface. Export it again.</source>
        <translation>机器人模型：网格文件 {mesh} 中没有任何表面。请重新导出。</translation>
    </message>
    <message>
        <source>The arm reported: {status}.</source>
        <translation>机械臂曾报告：{status}。</translation>
    </message>
    <message>
        <source>Not possible now: {reason}.</source>
        <translation>现在无法执行：{reason}。</translation>
    </message>
    <message>
        <source>The program is still finding out which protocol the arm speaks. Wait a second.</source>
        <translation>程序仍在识别机械臂使用的协议，请稍候一秒。</translation>
    </message>
    <message>
        <source>{parameter}: {value} is out of range. Enter a value from {minimum} to {maximum}.</source>
        <translation>{parameter}：{value} 超出范围，请输入 {minimum} 至 {maximum} 之间的值。</translation>
    </message>
    <message>
        <source>{parameter}: “{value}” is not a number. Enter a value from {minimum} to {maximum}.</source>
        <translation>{parameter}：“{value}”不是数字，请输入 {minimum} 至 {maximum} 之间的值。</translation>
    </message>
    <message>
        <source>{parameter}: {value} is not possible. Choose one of {choices}.</source>
        <translation>{parameter}：不能设为 {value}，请从 {choices} 中选择。</translation>
    </message>
    <message>
        <source>This arm&apos;s protocol (generation {generation}) has no such settings; generation 2 has.</source>
        <translation>本机械臂的协议（第 {generation} 代）没有这些参数，第 2 代才有。</translation>
    </message>
    <message>
        <source>{parameter} would have to be sent along unchanged and has not been read from the arm. Read it first.</source>
        <translation>{parameter}须随同原值一起发送，但尚未从机械臂读到，请先读取。</translation>
    </message>
    <message>
        <source>{parameter} would have to be sent along, and what the arm holds there is corrupt. Enter a value for it as well.</source>
        <translation>{parameter}须随同发送，而机械臂中保存的值已损坏，请同时为它输入一个值。</translation>
    </message>
    <message>
        <source>Joint {joint}: the min. angle {minimum}° must be below the max. angle {maximum}°. Change one of them.</source>
        <translation>关节 {joint}：最小角度 {minimum}° 必须小于最大角度 {maximum}°，请修改其中之一。</translation>
    </message>
    <message>
        <source>The arm did not answer (0x476). Nothing says that it took this over: read the values again, then save once more.</source>
        <translation>机械臂没有应答（0x476），无法确认已生效：请重新读取后再保存一次。</translation>
    </message>
    <message>
        <source>The arm did not answer when asked for the value: what it holds is not known. Read again.</source>
        <translation>读取时机械臂没有应答，其当前值未知，请重新读取。</translation>
    </message>
    <message>
        <source>{parameter}: {value} was sent and answered, but the arm holds {held}. It did not take this value; try another one.</source>
        <translation>{parameter}：已发送 {value} 且有应答，但机械臂中仍为 {held}，该值未被采用，请换一个值。</translation>
    </message>
    <message>
        <source>No row is chosen. Click one in the table first.</source>
        <translation>未选择行。请先在表格中点击一行。</translation>
    </message>
    <message>
        <source>The program could not finish this: {text}. Try again.</source>
        <translation>程序未能完成这项工作：{text}。请重试。</translation>
    </message>
    <message>
        <source>Not run: the arm has moved by {value}° since it was checked. Press Run again.</source>
        <translation>未运行：检查之后机械臂又移动了 {value}°。请再次点击发送。</translation>
    </message>
    <message>
        <source>Not run: the arm&apos;s joint limits have changed since the check. Press Run again.</source>
        <translation>未运行：机械臂的关节限位与检查时不同。请再次点击发送。</translation>
    </message>
    <message>
        <source>No trajectory is running: nothing to pause.</source>
        <translation>没有正在执行的轨迹，无法暂停。</translation>
    </message>
    <message>
        <source>No trajectory is paused: nothing to continue.</source>
        <translation>没有已暂停的轨迹，无法继续。</translation>
    </message>
    <message>
        <source>The 3D view ended unexpectedly ({text}).</source>
        <translation>3D 视图意外结束（{text}）。</translation>
    </message>
    <message>
        <source>The 3D view is not available: this computer offers no OpenGL. Install a graphics driver or Mesa (on Debian the packages libegl1 and libgl1-mesa-dri) and start the 3D view again.</source>
        <translation>3D 视图不可用：这台电脑没有 OpenGL。请安装显卡驱动或 Mesa（Debian 上为软件包 libegl1 和 libgl1-mesa-dri），然后重新启动 3D 视图。</translation>
    </message>
    <message>
        <source>The 3D view stopped responding.</source>
        <translation>3D 视图没有响应。</translation>
    </message>
    <message>
        <source>“{name}” has no points. Add points, or choose another trajectory.</source>
        <translation>“{name}”没有轨迹点，请添加轨迹点或选择其他轨迹。</translation>
    </message>
    <message>
        <source>There is no row {row}: the last one is {maximum}. Choose another row.</source>
        <translation>没有第 {row} 行，最后一行是第 {maximum} 行，请另选一行。</translation>
    </message>
    <message>
        <source>A trajectory or recording is under way, be it paused or dwelling. Wait until it is done, or end the run first.</source>
        <translation>轨迹或录制正在运行（暂停、停留也算）。请等待其完成，或先结束运行。</translation>
    </message>
    <message>
        <source>The device was disconnected while it ran: the arm was told before to end its motion.</source>
        <translation>运行中断开了设备，断开前已令机械臂结束运动。</translation>
    </message>
    <message>
        <source>The run under way sets the lamps itself. Wait until it is done, or end the run first.</source>
        <translation>当前运行会自行控制灯光。请等待其完成，或先结束运行。</translation>
    </message>
    <message>
        <source>The arm is being jogged. Let go first, then press again.</source>
        <translation>正在点动机械臂。请先松开，再按一次。</translation>
    </message>
    <message>
        <source>A motion of the arm is paused: it holds back every new target. Press Continue or a Clear button under Drag teaching, Planned trajectory.</source>
        <translation>机械臂的运动已暂停，新目标不会执行。请在“示教”的“轨迹指令”中继续或清除。</translation>
    </message>
    <message>
        <source>The arm was told to end its motion and still moves. Press the emergency stop if it must not.</source>
        <translation>已发送终止指令，但机械臂仍在运动；如有危险请按急停。</translation>
    </message>
    <message>
        <source>Joint {joint} does not follow: it is {away}° behind. See what keeps it, or replay more slowly.</source>
        <translation>关节 {joint} 未能跟随，落后 {away}°，请检查受阻原因或降低回放速度。</translation>
    </message>
    <message>
        <source>The arm has not reported its end pose: an arc has no beginning. Wait for it.</source>
        <translation>机械臂尚未反馈末端位姿，圆弧没有起点，请稍候。</translation>
    </message>
    <message>
        <source>Row {row}: this arm&apos;s protocol moves the gripper by other values (generation 1 by an angle, generation 2 by an opening). Change the gripper&apos;s action.</source>
        <translation>第 {row} 行：本机械臂协议的夹爪参数不同（第一代用角度，第二代用开度），请修改夹爪动作。</translation>
    </message>
    <message>
        <source>The file is broken or cut short: line {line}, column {column} is not JSON. Nothing was changed; choose another file, or correct that line.</source>
        <translation>文件已损坏或不完整：第 {line} 行第 {column} 列不是 JSON。未作任何更改；请选择其他文件，或修正该行。</translation>
    </message>
    <message>
        <source>This is not a parameter backup of this program. Nothing was changed; choose another file.</source>
        <translation>这不是本程序的参数备份文件。未作任何更改；请选择其他文件。</translation>
    </message>
    <message>
        <source>The file has format version {version}; this program reads version {known}. Open it with the program that wrote it, or update this one.</source>
        <translation>文件的格式版本为 {version}，本程序只能读取版本 {known}。请用保存它的程序打开，或更新本程序。</translation>
    </message>
    <message>
        <source>The file lacks the field “{field}”. Nothing was changed; choose another file, or add the field.</source>
        <translation>文件缺少字段“{field}”。未作任何更改；请选择其他文件，或补上该字段。</translation>
    </message>
    <message>
        <source>The file says “{value}” in the field “{field}”, which is not valid. Nothing was changed; choose another file, or correct the field.</source>
        <translation>文件的字段“{field}”为“{value}”，该值无效。未作任何更改；请选择其他文件，或修正该字段。</translation>
    </message>
    <message>
        <source>The file names {parameter} a second time, in “{field}”. Nothing was changed; remove one of the two.</source>
        <translation>文件中的{parameter}重复（“{field}”）。未作任何更改；请删去其中一个。</translation>
    </message>
    <message>
        <source>The file holds no parameter. Nothing was changed; choose another file.</source>
        <translation>文件中没有参数。未作任何更改；请选择其他文件。</translation>
    </message>
    <message>
        <source>The file {path} cannot be read: {text}. Choose another one.</source>
        <translation>无法读取文件 {path}：{text}。请选择其他文件。</translation>
    </message>
    <message>
        <source>The backup could not be written to {path}: {text}. Choose another folder.</source>
        <translation>无法将备份写入 {path}：{text}。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>Nothing has been read from the arm. Press Read first.</source>
        <translation>尚未从机械臂读到任何参数。请先点击“读取”。</translation>
    </message>
    <message>
        <source>It is not in the library any more.</source>
        <translation>它已不在轨迹库中。</translation>
    </message>
    <message>
        <source>The file cannot be read: {text}.</source>
        <translation>无法读取文件：{text}。</translation>
    </message>
    <message>
        <source>The file has {value} MB; at most {maximum} MB can be read.</source>
        <translation>文件大小为 {value} MB，最大可读取 {maximum} MB。</translation>
    </message>
    <message>
        <source>This is not text in UTF-8 or GBK. Save it as a text file in UTF-8.</source>
        <translation>不是 UTF-8 或 GBK 编码的文本。请另存为 UTF-8 文本文件。</translation>
    </message>
    <message>
        <source>This is not text in {value}. Choose another encoding.</source>
        <translation>这不是 {value} 编码的文本。请选择其他编码。</translation>
    </message>
    <message>
        <source>This is not a trajectory file that the program knows. Import it by columns.</source>
        <translation>不是程序可识别的轨迹文件。请按列导入。</translation>
    </message>
    <message>
        <source>No rows of numbers are found here. Choose a file with one point a row.</source>
        <translation>未找到由数字组成的行。请选择每行一个点的文件。</translation>
    </message>
    <message>
        <source>The file is of version {value}; this program reads up to version {maximum}. Update the program.</source>
        <translation>文件版本为 {value}，本程序最高支持版本 {maximum}。请更新程序。</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>文件为空。</translation>
    </message>
    <message>
        <source>The file is damaged: {text}.</source>
        <translation>文件已损坏：{text}。</translation>
    </message>
    <message>
        <source>“{value}” is not a kind of line. A line begins with J, P, L, C or #.</source>
        <translation>“{value}”不是有效的行类型。行首应为 J、P、L、C 或 #。</translation>
    </message>
    <message>
        <source>“{value}” is not an entry of the header; use name, note or modified.</source>
        <translation>“{value}”不是有效的文件头条目，可用条目为 name、note 和 modified。</translation>
    </message>
    <message>
        <source>“{value}” is given twice. Keep one.</source>
        <translation>“{value}”重复出现，请只保留一个。</translation>
    </message>
    <message>
        <source>“{value}” is not a valid {field}. Write it as {example}.</source>
        <translation>“{value}”不是有效的 {field}。请写成 {example}。</translation>
    </message>
    <message>
        <source>“{value}” is not a number.</source>
        <translation>“{value}”不是数字。</translation>
    </message>
    <message>
        <source>{value} numbers where {expected} belong.</source>
        <translation>此处有 {value} 个数，应为 {expected} 个。</translation>
    </message>
    <message>
        <source>The closing quotation mark is missing.</source>
        <translation>缺少右引号。</translation>
    </message>
    <message>
        <source>The column “{field}” is missing.</source>
        <translation>缺少列“{field}”。</translation>
    </message>
    <message>
        <source>The column “{value}” is unknown.</source>
        <translation>未知的列“{value}”。</translation>
    </message>
    <message>
        <source>The column “{field}” is there twice.</source>
        <translation>列“{field}”重复出现。</translation>
    </message>
    <message>
        <source>{value} cells where there are {expected} columns.</source>
        <translation>此行有 {value} 个单元格，而表格有 {expected} 列。</translation>
    </message>
    <message>
        <source>“{value}” is not a date and time. Write it as 2026-01-31T12:00:00.</source>
        <translation>“{value}”不是有效的日期时间。请写成 2026-01-31T12:00:00。</translation>
    </message>
    <message>
        <source>This is not valid JSON: {text}.</source>
        <translation>不是有效的 JSON：{text}。</translation>
    </message>
    <message>
        <source>“{field}” is missing.</source>
        <translation>缺少“{field}”。</translation>
    </message>
    <message>
        <source>“{value}” is unknown.</source>
        <translation>未知的“{value}”。</translation>
    </message>
    <message>
        <source>“{field}” is not what it should be: {expected}.</source>
        <translation>“{field}”的内容不符合要求，应为：{expected}。</translation>
    </message>
    <message>
        <source>The cell has no user frame “{name}”, which the point is in. Choose the cell that has it, or make a frame of this name under Cell.</source>
        <translation>该点位于用户坐标系“{name}”中，而当前单元没有这个坐标系。请选择含有该坐标系的单元，或在“单元”中新建同名坐标系。</translation>
    </message>
    <message>
        <source>{field}: {value}{unit} is out of range. Enter a value from {minimum}{unit} to {maximum}{unit}.</source>
        <translation>{field}：{value}{unit} 超出范围。请输入 {minimum}{unit} 至 {maximum}{unit} 之间的值。</translation>
    </message>
    <message>
        <source>{field}: “{value}” is not a number.</source>
        <translation>{field}：“{value}”不是数字。</translation>
    </message>
    <message>
        <source>{field}: {value} is not a whole number.</source>
        <translation>{field}：{value} 不是整数。</translation>
    </message>
    <message>
        <source>{field}: {value} values; six belong there, and a middle only to MOVE C.</source>
        <translation>{field}：有 {value} 个值，应为六个；只有 MOVE C 才有中间位姿。</translation>
    </message>
    <message>
        <source>“{value}” is not a kind of motion. Use MOVE J, MOVE P, MOVE L or MOVE C.</source>
        <translation>“{value}”不是有效的运动类型，可用类型为 MOVE J、MOVE P、MOVE L 和 MOVE C。</translation>
    </message>
    <message>
        <source>The time {value} s is before the one above, {minimum} s.</source>
        <translation>时间 {value} s 早于上一行的 {minimum} s。</translation>
    </message>
    <message>
        <source>{field}: {value} characters; up to {maximum} are kept. Shorten it.</source>
        <translation>{field}：有 {value} 个字符，最多 {maximum} 个。请缩短。</translation>
    </message>
    <message>
        <source>{field}: holds a character that cannot be kept. Remove it.</source>
        <translation>{field}：含有无法保存的字符。请删除该字符。</translation>
    </message>
    <message>
        <source>An arc needs a middle pose, which no conversion can know. Enter it by hand.</source>
        <translation>圆弧需要中间位姿，无法由转换得到。请手动输入。</translation>
    </message>
    <message>
        <source>A trajectory needs a name. Enter one.</source>
        <translation>轨迹需要名称。请输入名称。</translation>
    </message>
    <message>
        <source>The name has {value} characters; up to {maximum} are kept. Shorten it.</source>
        <translation>名称有 {value} 个字符，最多 {maximum} 个。请缩短。</translation>
    </message>
    <message>
        <source>There is a “{name}” already. Choose another name.</source>
        <translation>已存在“{name}”。请使用其他名称。</translation>
    </message>
    <message>
        <source>“{name}” has been changed since it was made, and is kept. Delete it if you do not want it.</source>
        <translation>“{name}”新建后已被修改，予以保留。不需要时请将其删除。</translation>
    </message>
    <message>
        <source>“{name}” is no longer among the deleted ones. It has been restored already, or its time was up.</source>
        <translation>“{name}”已不在最近删除中：已经恢复，或已过保留期限。</translation>
    </message>
    <message>
        <source>The file of “{name}” is damaged and is not written over. Save under another name.</source>
        <translation>“{name}”的文件已损坏，不会被覆盖。请以其他名称保存。</translation>
    </message>
    <message>
        <source>“{name}” was not saved: {text}. What was kept before is unchanged. Check the disk, then save again.</source>
        <translation>“{name}”未保存：{text}。原有内容未变。请检查磁盘后重新保存。</translation>
    </message>
    <message>
        <source>Not deleted: {name}: {text}. Check the rights to the library&apos;s folder.</source>
        <translation>未删除：{name}：{text}。请检查轨迹库文件夹的权限。</translation>
    </message>
    <message>
        <source>Not restored: {name}: {text}. Check the rights to the library&apos;s folder.</source>
        <translation>未恢复：{name}：{text}。请检查轨迹库文件夹的权限。</translation>
    </message>
    <message>
        <source>The library cannot be read: {name}: {text}. Check the rights to this folder.</source>
        <translation>无法读取轨迹库：{name}：{text}。请检查该文件夹的权限。</translation>
    </message>
    <message>
        <source>Columns {first} and {second} are both {field}. Leave one of them out.</source>
        <translation>第 {first} 列和第 {second} 列都是{field}。请去掉其中一列。</translation>
    </message>
    <message>
        <source>Still missing: {missing}. Say which columns hold them.</source>
        <translation>还缺少：{missing}。请指定对应的列。</translation>
    </message>
    <message>
        <source>Column {column}: {field} is not given in “{value}”. Choose one of {choices}.</source>
        <translation>第 {column} 列：{field}不能使用单位“{value}”。请选择 {choices} 之一。</translation>
    </message>
    <message>
        <source>The speed override is 0 %: raise it, then hold “Continue” for 1 s.</source>
        <translation>运行倍率为 0 %：请先调高，再按住“继续”1 秒。</translation>
    </message>
    <message>
        <source>How far this gripper opens is not known: the arm has told no stroke limit. Set it in Gripper settings, or enter a target in Gripper control.</source>
        <translation>不知道此夹爪能张开多大：机械臂没有报告行程限位。请在“夹爪设置”中设置，或在“夹爪控制”中输入目标。</translation>
    </message>
    <message>
        <source>The gripper tells an angle now, and a point keeps an opening. Move it by an opening in Gripper control first.</source>
        <translation>夹爪当前反馈的是角度，而点中保存的是开度。请先在“夹爪控制”中按开度移动夹爪。</translation>
    </message>
    <message>
        <source>{frames} of the arm has not been heard for {seconds} s: its position is unknown. Check its power and the CAN cable; nothing is sent until it is heard again.</source>
        <translation>已有 {seconds} 秒未收到机械臂的 {frames}：无法得知其位置。请检查电源与 CAN 线；重新收到之前不发送任何运动指令。</translation>
    </message>
    <message>
        <source>Another program controls the arm ({frames}). Wait until it has been quiet for 2 s and the arm rests, or take over when it pauses. The stop works at any time.</source>
        <translation>另一程序正在控制机械臂（{frames}）。请等它静默 2 秒且机械臂静止，或在它停顿时接管。急停随时有效。</translation>
    </message>
    <message>
        <source>A leader arm moves this arm ({frames}). Switch the leader off, or make it a motion output. The stop works at any time.</source>
        <translation>主臂正在带动本机械臂（{frames}）。请关闭主臂，或将其设为运动输出臂。急停随时有效。</translation>
    </message>
    <message>
        <source>The other program is still sending ({frames}): it can be taken over half a second after its last frame. Against a stream only the stop wins.</source>
        <translation>另一程序仍在发送（{frames}）：其最后一帧过后半秒才能接管。对持续的数据流只有急停有效。</translation>
    </message>
    <message>
        <source>This connection only listens: nothing is sent but the emergency stop. Connect without Listen only to command the arm.</source>
        <translation>当前连接为“只听”：除急停外不发送任何帧。要控制机械臂，请取消“只听”后重新连接。</translation>
    </message>
    <message>
        <source>No other program moves the arm.</source>
        <translation>没有其他程序在移动机械臂。</translation>
    </message>
    <message>
        <source>The arm holds back a motion at 0 %. Hold Continue or press Give up in the line above the panels first.</source>
        <translation>速度为 0 %，机械臂保留着未完成的运动。请先在面板上方的提示行按住“继续”或点击“放弃”。</translation>
    </message>
    <message>
        <source>No motion is held back.</source>
        <translation>没有被保留的运动。</translation>
    </message>
    <message>
        <source>Something else has ended this motion. Look at the arm, then start again.</source>
        <translation>该运动已被其他事件终止。请查看机械臂后重新开始。</translation>
    </message>
    <message>
        <source>This connection only listens: nothing is sent on it but the emergency stop.</source>
        <translation>此连接为只听：除急停外不发送任何帧。</translation>
    </message>
    <message>
        <source>For half a second {device} could send nothing, because nobody on the bus acknowledges. Check the arm&apos;s power, the CAN cable, the terminating resistors and the bit rate (1 Mbit/s).</source>
        <translation>{device} 已有半秒发不出任何帧，因为总线上无人应答。请检查机械臂电源、CAN 线、终端电阻和波特率（1 Mbit/s）。</translation>
    </message>
    <message>
        <source>For half a second {device} has taken no frame to send, though frames are heard. Unplug the adapter and plug it in again; if that does not help, check its driver.</source>
        <translation>{device} 已有半秒不接收要发送的帧，但仍能收到帧。请拔下适配器再插上；若无效，请检查其驱动。</translation>
    </message>
    <message>
        <source>Joint {joints} does not stand where it stood at the press: no zero was sent. Try again where it shall be.</source>
        <translation>关节 {joints} 已不在按下按钮时的位置：未发送零点。请在要设为零点的位置重试。</translation>
    </message>
    <message>
        <source>Another program is writing the settings file {path}. The settings hold until this program ends; change them once more to save them.</source>
        <translation>另一程序正在写入设置文件 {path}。设置在本程序退出前有效；再更改一次即可保存。</translation>
    </message>
    <message>
        <source>Nothing was sent: the arm was still being set or asked something a second after the press. Try again.</source>
        <translation>未发送：按下一秒后机械臂仍在进行其他设置或查询。请重试。</translation>
    </message>
    <message>
        <source>The arm was silent meanwhile, or another arm answers: nothing more was sent. See that it is the right arm, then try again.</source>
        <translation>其间机械臂曾无应答，或应答的是另一台机械臂：未再发送。请确认是正确的机械臂，然后重试。</translation>
    </message>
    <message>
        <source>Robot description: {path} ended the 3D view while it was loaded ({text}). It is put aside; choose another one.</source>
        <translation>机器人描述：加载 {path} 时 3D 视图意外结束（{text}）。该文件已停用，请另选一个。</translation>
    </message>
    <message>
        <source>Robot description: loading {path} does not come to an end. It is put aside; choose another one.</source>
        <translation>机器人描述：{path} 一直加载不完。该文件已停用，请另选一个。</translation>
    </message>
    <message>
        <source>Jogging ended: held for {seconds} s without a movement of the mouse or another key. Let go and press again; move the mouse a little while you hold it for long.</source>
        <translation>点动已结束：按住 {seconds} 秒期间鼠标未移动，也没有按其他键。请松开后重新按下；需要长时间按住时，请稍微移动鼠标。</translation>
    </message>
    <message>
        <source>Identifier: “{value}” is not a hexadecimal number. Enter 000 to 7FF, for example 151.</source>
        <translation>ID：“{value}”不是十六进制数。请输入 000 至 7FF，例如 151。</translation>
    </message>
    <message>
        <source>Identifier: {value} has more than 11 bits; the arm uses none of those. Enter 000 to 7FF.</source>
        <translation>ID：{value} 超过 11 位，机械臂不使用这样的 ID。请输入 000 至 7FF。</translation>
    </message>
    <message>
        <source>Data: “{value}” is not whole bytes. Enter two hexadecimal figures for each byte, for example 01 0A FF.</source>
        <translation>数据：“{value}”不是完整的字节。每个字节请输入两位十六进制数，例如 01 0A FF。</translation>
    </message>
    <message>
        <source>Data: {count} bytes do not fit into a frame. Enter 8 at most.</source>
        <translation>数据：{count} 字节超出一帧的容量。最多输入 8 字节。</translation>
    </message>
    <message>
        <source>{frame} is sent by the arm itself: two senders of one identifier disturb the bus, and others would take it for the arm&apos;s feedback. Choose an identifier that hosts send.</source>
        <translation>{frame} 是机械臂自己发送的帧：同一 ID 有两个发送方会干扰总线，其他程序也会误以为是机械臂的反馈。请选择由上位机发送的 ID。</translation>
    </message>
    <message>
        <source>{frame} is kept for firmware upgrades: what it does is not public, and it may leave the arm without firmware. Use the maker&apos;s upgrade program.</source>
        <translation>{frame} 保留用于固件升级：其作用没有公开资料，可能使机械臂失去固件。请使用厂家的升级程序。</translation>
    </message>
    <message>
        <source>This frame acts on the arm: hold the button for a second to send it.</source>
        <translation>该帧会对机械臂起作用：请按住按钮 1 秒再发送。</translation>
    </message>
    <message>
        <source>A log is being written already. Stop it first.</source>
        <translation>日志已在写入中。请先停止日志。</translation>
    </message>
    <message>
        <source>No log is being written: there is nothing to stop.</source>
        <translation>当前没有在写日志，无需停止。</translation>
    </message>
    <message>
        <source>MF4 needs the package asammdf (pip install asammdf).</source>
        <translation>MF4 需要 asammdf 软件包（pip install asammdf）。</translation>
    </message>
    <message>
        <source>Cancelled. The recording itself is complete, as .blf.</source>
        <translation>已取消。录制本身完整，保存为 .blf。</translation>
    </message>
    <message>
        <source>The point for {point} is {value} mm from the origin; at least {minimum} mm are needed. Take it again, further away.</source>
        <translation>用于 {point} 的点距原点只有 {value} mm，至少需要 {minimum} mm。请到更远处重新采集。</translation>
    </message>
    <message>
        <source>“{name}” is marked as held; this would drop the mark. Let go of it under Held first.</source>
        <translation>“{name}”已标记为夹持中，这样操作会取消该标记。请先在“工件”中标为“已放下”。</translation>
    </message>
    <message>
        <source>Row {row} is in the user frame “{name}”, whose place was not worked out. Send it again.</source>
        <translation>第 {row} 行位于用户坐标系“{name}”中，但尚未换算到基坐标系。请重新发送。</translation>
    </message>
    <message>
        <source>Nobody knows which way the arm would take, and a work area or a lowest height is in force. Switch its planes and boxes off under Cell, or the height under Settings, first.</source>
        <translation>无人知道机械臂会走哪条路径，而工作区域或最低高度正在生效。请先在“单元”中关闭其平面和盒体，或在“设置”中关闭最低高度。</translation>
    </message>
    <message>
        <source>The last minutes are being saved already. Wait a moment.</source>
        <translation>最近几分钟的内容正在保存，请稍候。</translation>
    </message>
    <message>
        <source>Nothing has been heard on the bus yet: there is nothing to save.</source>
        <translation>总线上还没有收到任何帧，没有可保存的内容。</translation>
    </message>
    <message>
        <source>This name is not possible. Use small letters, digits and _, 15 at most, beginning with a letter, as in arm_left, and no name that the system itself gives (can0, eth0).</source>
        <translation>名称不可用。请只用小写字母、数字和 _，以字母开头，最多 15 个字符，例如 arm_left；不能用系统自动分配的名称（can0、eth0）。</translation>
    </message>
    <message>
        <source>The adapter&apos;s serial number cannot be used: {text}.</source>
        <translation>适配器的序列号无法使用：{text}。</translation>
    </message>
    <message>
        <source>The system refused it: {text}.</source>
        <translation>系统拒绝：{text}。</translation>
    </message>
    <message>
        <source>The local interface cannot be opened at {path}: {text}.</source>
        <translation>无法在 {path} 打开本地接口：{text}。</translation>
    </message>
    <message>
        <source>{value} % is more than the {maximum} % that the operator allows now.</source>
        <translation>{value} % 超过操作员目前允许的 {maximum} %。</translation>
    </message>
    <message>
        <source>The disk of {folder} is full. What was written before can be read. Free some room or choose another folder, then record again.</source>
        <translation>{folder} 所在的磁盘已满。此前写入的内容可以读取。请清理磁盘空间或选择其他文件夹，然后重新记录。</translation>
    </message>
    <message>
        <source>The folder {folder} cannot be written. Choose another folder for the logs, or allow this one to be written.</source>
        <translation>文件夹 {folder} 无法写入。请为日志选择其他文件夹，或允许写入此文件夹。</translation>
    </message>
    <message>
        <source>The folder {folder}, or its disk, is gone. Plug it in again or choose another folder, then record again.</source>
        <translation>文件夹 {folder} 或其所在磁盘已不存在。请重新插入磁盘或选择其他文件夹，然后重新记录。</translation>
    </message>
    <message>
        <source>There is a file called “{name}” in the folder already. Choose another name.</source>
        <translation>文件夹中已有名为“{name}”的文件。请换一个名称。</translation>
    </message>
    <message>
        <source>{name} is a log without a single frame: there is nothing to replay. Record again, with the arm switched on.</source>
        <translation>{name} 中没有任何报文，无法回放。请在机械臂上电后重新记录。</translation>
    </message>
    <message>
        <source>Nothing in {name} reads as a frame of a CAN log ({text}). Choose the file that the recording program has written, with its own ending.</source>
        <translation>{name} 中没有可读的 CAN 报文（{text}）。请选择记录程序写出的文件，并保留其扩展名。</translation>
    </message>
    <message>
        <source>Nothing in {name} reads as a frame of a CAN log of its ending. Choose the file that the recording program has written, with its own ending.</source>
        <translation>{name} 中没有与其扩展名相符的 CAN 报文。请选择记录程序写出的文件，并保留其扩展名。</translation>
    </message>
    <message>
        <source>{name} is a packed archive, whatever its ending says. Unpack it, and open the log that was in it.</source>
        <translation>无论扩展名如何，{name} 都是压缩包。请先解压，再打开其中的日志。</translation>
    </message>
    <message>
        <source>By its name {name} is no CAN log. Known endings: {known}, most of them also with .gz behind. Rename the file, or choose another.</source>
        <translation>从文件名看，{name} 不是 CAN 日志。可识别的扩展名：{known}，多数也可再加 .gz。请改名或选择其他文件。</translation>
    </message>
    <message>
        <source>{name} cannot be opened: {text}. Look whether it is still there and may be read.</source>
        <translation>无法打开 {name}：{text}。请检查文件是否还在、是否有读取权限。</translation>
    </message>
    <message>
        <source>The log is read into temporary files, and these cannot be written: {text}. Make room on the disk, or set TMPDIR to a folder with more.</source>
        <translation>读取日志需要写临时文件，但无法写入：{text}。请腾出磁盘空间，或将 TMPDIR 设为空间更大的文件夹。</translation>
    </message>
    <message>
        <source>{name} can be read no further: {text}. Open it again; if that does not help, copy it to another disk first.</source>
        <translation>无法继续读取 {name}：{text}。请重新打开；若仍不行，请先将其复制到其他磁盘。</translation>
    </message>
    <message>
        <source>{name} is gone. Plug it in again or switch it on.</source>
        <translation>{name} 已断开。请重新插入或打开电源。</translation>
    </message>
    <message>
        <source>No more data from {name}. Release all its buttons and press again.</source>
        <translation>收不到 {name} 的数据。请松开所有按键后重新按下。</translation>
    </message>
    <message>
        <source>The dead-man button was held for {seconds} s without a movement of the device. Press again.</source>
        <translation>使能键按住 {seconds} 秒而设备没有任何动作。请重新按下。</translation>
    </message>
    <message>
        <source>The arm&apos;s firmware {firmware} does not have this: it came with {since}. Updates come from the maker&apos;s support.</source>
        <translation>机械臂固件 {firmware} 不支持此功能：自 {since} 起支持。升级请联系厂家支持。</translation>
    </message>
    <message>
        <source>The arm has not named its firmware, and only {since} and later have this. Connect again to ask for it.</source>
        <translation>机械臂尚未报告固件版本，而此功能自 {since} 起支持。请重新连接以查询。</translation>
    </message>
    <message>
        <source>The arm&apos;s control mode is not known, or another one has the command: it would be changed along with this. Bring the arm to standby or CAN control first.</source>
        <translation>机械臂的控制模式未知，或由其他方控制：此操作会同时更改它。请先使机械臂进入待机或 CAN 控制模式。</translation>
    </message>
    <message>
        <source>Another program drives the arm in {other_mode} mode: a mode word of ours would leave its joints limp. End that program, hold the arm, and take the way back that the line above the panels offers.</source>
        <translation>另一程序正以{other_mode}模式驱动机械臂：本程序的模式指令会使关节失力。请结束该程序、扶住机械臂，再按面板上方提示行给出的方式恢复。</translation>
    </message>
    <message>
        <source>Not run: the arm&apos;s model or zeros have changed since the check. Press Run again.</source>
        <translation>未运行：机械臂的型号或零点约定与检查时不同。请再次点击发送。</translation>
    </message>
    <message>
        <source>The main window, or a page taken out of it, is not in front, or a menu is open. Click into one of them, then press again.</source>
        <translation>主窗口或取出的独立窗口不在最前，或有菜单打开。请点击其中一个窗口，再重新按下。</translation>
    </message>
    <message>
        <source>Nothing was sent: the arm was asked for its firmware version and has not named it within 0.9 s. With an older one it would fall. Try again; if it stays so, hold the arm and use the emergency stop.</source>
        <translation>未发送任何内容：已询问机械臂的固件版本，0.9 s 内没有答复。若固件较旧，机械臂会下坠。请重试；若仍如此，请扶住机械臂并使用急停。</translation>
    </message>
    <message>
        <source>Nothing was sent: asked for its firmware version, the arm named {versions}. With it, or with two arms on the bus, an arm would fall. Hold the arm and use the emergency stop.</source>
        <translation>未发送任何内容：询问固件版本时，机械臂答复为 {versions}。使用此固件，或总线上有两台机械臂时，机械臂会下坠。请扶住机械臂并使用急停。</translation>
    </message>
    <message>
        <source>The live stream needs the package foxglove-sdk ({text}): pip install &apos;armui[foxglove]&apos;, then switch it off and on. A program that was not installed by pip cannot have it.</source>
        <translation>实时数据流需要软件包 foxglove-sdk（{text}）：请运行 pip install &apos;armui[foxglove]&apos;，然后关闭再打开。不是用 pip 安装的程序无法使用。</translation>
    </message>
    <message>
        <source>The live stream cannot be served at port {port} ({text}). Choose another port in the settings.</source>
        <translation>无法在端口 {port} 提供实时数据流（{text}）。请在设置中选择其他端口。</translation>
    </message>
    <message>
        <source>The drag was cancelled: the arm, or what was dragged, has changed. Drag again.</source>
        <translation>拖动已放弃：机械臂或被拖动的内容已经改变。请重新拖动。</translation>
    </message>
    <message>
        <source>The target is {value} mm below the floor. Send it only if there is nothing there.</source>
        <translation>目标在地面以下 {value} mm。确认那里没有物体后再发送。</translation>
    </message>
    <message>
        <source>This is a CAN log, which holds no points. Under Log, “Replay another log…” opens it.</source>
        <translation>这是 CAN 日志，不含轨迹点。请在“日志”中用“回放其他日志…”打开。</translation>
    </message>
    <message>
        <source>Several rows are chosen. Choose the one to run.</source>
        <translation>选择了多行。请只选择要运行的一行。</translation>
    </message>
    <message>
        <source>The points have been changed since that run began: it cannot go on from a row of theirs. Choose “From row” and press Run.</source>
        <translation>该次运行开始后轨迹点已修改，不能从其中某行继续。请选择“起始行”，再按“发送”。</translation>
    </message>
    <message>
        <source>The log “{name}” is not in the folder any more, or cannot be read: {text}.</source>
        <translation>日志“{name}”已不在文件夹中，或无法读取：{text}。</translation>
    </message>
    <message>
        <source>“{name}” is still being written. Stop the log first.</source>
        <translation>“{name}”仍在写入。请先停止日志。</translation>
    </message>
    <message>
        <source>“{name}” is open in the replay window. Close that window first.</source>
        <translation>“{name}”正在回放窗口中打开，请先关闭该窗口。</translation>
    </message>
    <message>
        <source>Robot description: meshes like {mesh} are not supported. Supported kinds: {kinds}.</source>
        <translation>机器人描述：不支持网格文件 {mesh} 的格式。支持的格式：{kinds}。</translation>
    </message>
    <message>
        <source>Robot description: the mesh {mesh} has {size} MB; {most} MB are read at most. Export it with fewer triangles.</source>
        <translation>机器人描述：网格文件 {mesh} 有 {size} MB，最多读取 {most} MB。请减少三角面数后重新导出。</translation>
    </message>
    <message>
        <source>Robot description: the mesh {mesh} reaches farther than {most} m, or nowhere. A mesh in millimetres needs scale 0.001.</source>
        <translation>机器人描述：网格 {mesh} 超出 {most} m，或坐标无效。以毫米为单位的网格需要 scale 0.001。</translation>
    </message>
    <message>
        <source>Robot description: the meshes of {path} have more than {most} triangles together. Export them with fewer.</source>
        <translation>机器人描述：{path} 的网格合计超过 {most} 个三角面。请减少三角面数后重新导出。</translation>
    </message>
    <message>
        <source>Robot description: {path} takes more than {most} MB of memory to load. Export its meshes with fewer triangles.</source>
        <translation>机器人描述：加载 {path} 需要的内存超过 {most} MB。请减少网格的三角面数后重新导出。</translation>
    </message>
    <message>
        <source>A part of the program has failed: every motion of this program ends, and none begins while it fails. Copy the details of the error, then start the program again.</source>
        <translation>程序的一部分出错：本程序的所有运动均被结束，故障期间不会开始新的运动。请复制错误详细信息，然后重新启动程序。</translation>
    </message>
    <message>
        <source>The computer was about to sleep, or to end this program: the arm was told before to end its motion.</source>
        <translation>电脑即将休眠，或即将结束本程序：此前已命令机械臂结束运动。</translation>
    </message>
    <message>
        <source>The hand or what it holds would come to {value} mm; jogs end at {minimum} mm, as chosen under Settings. Jog upwards.</source>
        <translation>末端或工件将到 {value} mm；按“设置”中的选择，点动止于 {minimum} mm。请向上点动。</translation>
    </message>
    <message>
        <source>J{joint}: this step would go beyond its limit of {limit}°. Take a smaller step.</source>
        <translation>J{joint}：这一步会越过限位 {limit}°，请减小步长。</translation>
    </message>
    <message>
        <source>{device} needs the library libusb, which is not on this computer. Install it in a terminal: on Windows and macOS pip install libusb-package, on Debian and Ubuntu sudo apt install libusb-1.0-0</source>
        <translation>{device} 需要 libusb 库，但此电脑上没有。请在终端中安装：Windows 和 macOS 用 pip install libusb-package，Debian 和 Ubuntu 用 sudo apt install libusb-1.0-0</translation>
    </message>
    <message>
        <source>{text} is not a bit rate of an arm: nothing was changed.</source>
        <translation>{text} 不是机械臂的波特率：没有更改任何设置。</translation>
    </message>
    <message>
        <source>The question for the password was closed: nothing was changed.</source>
        <translation>密码窗口已关闭：没有更改任何设置。</translation>
    </message>
    <message>
        <source>{text} is the name of another adapter already.</source>
        <translation>{text} 已是另一个适配器的名称。</translation>
    </message>
    <message>
        <source>The helper ended without reporting what it did: {text}. Look at the diagnosis again.</source>
        <translation>辅助程序结束时没有说明结果：{text}。请重新诊断。</translation>
    </message>
    <message>
        <source>{text} has no bit rate yet. Switch it on with one first.</source>
        <translation>{text} 尚未设置波特率，请先按波特率启用。</translation>
    </message>
    <message>
        <source>Which channel of its adapter {text} is, is not known.</source>
        <translation>无法确定 {text} 是适配器的哪个通道。</translation>
    </message>
    <message>
        <source>{text} is not there any more. Plug the adapter in again.</source>
        <translation>{text} 已不存在，请重新插入适配器。</translation>
    </message>
    <message>
        <source>The adapter of {text} has no serial number: it cannot be told from another one, so nothing was saved.</source>
        <translation>{text} 的适配器没有序列号，无法与其他适配器区分，没有保存。</translation>
    </message>
    <message>
        <source>The system did not allow it: {text}. Nothing was changed; the commands below do the same in a terminal.</source>
        <translation>系统不允许：{text}。没有更改任何设置；可在终端中运行下面的命令。</translation>
    </message>
    <message>
        <source>{text} is not a CAN interface: nothing was changed.</source>
        <translation>{text} 不是 CAN 接口：没有更改任何设置。</translation>
    </message>
    <message>
        <source>Nothing is kept under the name {text}.</source>
        <translation>没有以 {text} 保存的设置。</translation>
    </message>
    <message>
        <source>{text} belongs to another program: nothing was written.</source>
        <translation>{text} 是其他程序的文件：没有写入。</translation>
    </message>
    <message>
        <source>The system said that it is done, and it is not: {text}. Unplug the adapter, plug it in again, and try once more.</source>
        <translation>系统称已完成，但实际没有：{text}。请拔下适配器重新插入，再试一次。</translation>
    </message>
    <message>
        <source>{text} is not a USB serial adapter: nothing was changed.</source>
        <translation>{text} 不是 USB 串口适配器：没有更改任何设置。</translation>
    </message>
    <message>
        <source>The system&apos;s program {text} did not answer within 5 s. Unplug the adapter and plug it in again.</source>
        <translation>系统程序 {text} 在 5 s 内没有响应。请拔下适配器重新插入。</translation>
    </message>
    <message>
        <source>The system&apos;s program {text} is missing. Install it.</source>
        <translation>缺少系统程序 {text}，请安装。</translation>
    </message>
    <message>
        <source>The arm moves, and {interface} is the only way to it: switched off, even for a moment, the arm goes on with what it was told last, and no emergency stop reaches it. Let the motion end or stop it first.</source>
        <translation>机械臂正在运动，而 {interface} 是与它的唯一连接：即使短暂停用，机械臂也会继续执行最后收到的指令，急停无法送达。请等运动结束，或先停止机械臂。</translation>
    </message>
    <message>
        <source>{text} is still switched on, though the system said that it is off.</source>
        <translation>系统称 {text} 已停用，但它仍处于启用状态。</translation>
    </message>
    <message>
        <source>The program, the computer or the adapter stood still for {seconds} s, so the replay was ended. Let the computer do less beside it, keep it from sleeping, and start the replay anew.</source>
        <translation>程序、计算机或适配器停顿了 {seconds} 秒，回放已结束。请减少计算机的其他任务并禁止休眠，然后重新开始回放。</translation>
    </message>
    <message>
        <source>MF4 needs the Python package asammdf, which is no part of this installed program, and cannot be added to it. Use BLF.</source>
        <translation>MF4 需要 Python 软件包 asammdf，此安装版程序不含它，也无法添加。请使用 BLF。</translation>
    </message>
    <message>
        <source>{device} needs the Python package {package}, which is no part of this installed program, and cannot be added to it. Use another adapter, or armui from its source with that package.</source>
        <translation>{device} 需要 Python 软件包 {package}，此安装版程序不含它，也无法添加。请换用其他适配器，或从源码运行 armui 并安装该软件包。</translation>
    </message>
    <message>
        <source>{path} exists already, and is left as it is. Choose another name.</source>
        <translation>{path} 已存在，保持不变。请另取名称。</translation>
    </message>
    <message>
        <source>The report could not be saved as {path}: {text}. Free some room or choose another folder.</source>
        <translation>报告无法保存为 {path}：{text}。请腾出空间或选择其他文件夹。</translation>
    </message>
    <message>
        <source>The gripper table has {value} pairs; it holds {maximum} at most. Leave some out.</source>
        <translation>夹爪校准表有 {value} 组，最多 {maximum} 组。请删去一些。</translation>
    </message>
    <message>
        <source>Joint {joint} is in doubt: it may stand 85° from what it reports, so nothing drives it. Bring it to its mark by hand, with the motors off and the arm held.</source>
        <translation>关节 {joint} 存疑：与上报位置最多可能相差 85°，因此不会驱动它。请在电机关闭、扶住机械臂的情况下用手转到刻线。</translation>
    </message>
    <message>
        <source>Joint {joints} may stand elsewhere than it reports: its reference is in doubt. Check it, or agree to motions in the line above the panels. Single motions up to {maximum} % need no agreement.</source>
        <translation>关节 {joints} 的实际位置可能与上报不符：其零位基准存疑。请检查，或在面板上方的提示行中同意运动。不超过 {maximum} % 的单次运动无需同意。</translation>
    </message>
    <message>
        <source>The gripper table needs two pairs at least, so that openings between them are known.</source>
        <translation>夹爪校准表至少需要两组，才能得知其间的开度。</translation>
    </message>
    <message>
        <source>A work area has at most {planes} planes and {boxes} boxes. Delete one first.</source>
        <translation>工作区最多有 {planes} 个平面和 {boxes} 个长方体。请先删除一个。</translation>
    </message>
    <message>
        <source>The poses do not fit together: pose {pose} is {value} mm off, at most {maximum} mm are allowed. Take that pose again, or leave it out.</source>
        <translation>各位姿不相符：位姿 {pose} 偏差 {value} mm，最大允许 {maximum} mm。请重新采集该位姿，或不用它。</translation>
    </message>
    <message>
        <source>Another program has changed the file {path} meanwhile; it was not overwritten. Export your cell under another name, then start the program again.</source>
        <translation>另一程序此间更改了文件 {path}；未覆盖它。请把您的单元以另一名称导出，再重新启动程序。</translation>
    </message>
    <message>
        <source>{count} poses are taken; at least {minimum} are needed. Take another one.</source>
        <translation>已采集 {count} 个位姿，至少需要 {minimum} 个。请再采集一个。</translation>
    </message>
    <message>
        <source>Not run: tool, load, cell, settings or choices have changed since the check. Press Run again.</source>
        <translation>未运行：检查之后工具、负载、单元、设置或选项已改变。请重新发送。</translation>
    </message>
    <message>
        <source>The arm is not at rest: a pose that is taken now would be wrong. Wait until it stands still.</source>
        <translation>机械臂未静止：此时采集的位姿不准确。请等它停稳。</translation>
    </message>
    <message>
        <source>Look at the whole arm first and say which joints stand elsewhere than the picture shows.</source>
        <translation>请先查看整台机械臂，并指出哪些关节与画面不同。</translation>
    </message>
    <message>
        <source>Joint {joint} has no mark, and no reference pose is taught: compare it with the picture.</source>
        <translation>关节 {joint} 没有刻线，也没有示教基准位姿：请与画面比较。</translation>
    </message>
    <message>
        <source>The pose is not heard any more: nothing was taken. Wait until the arm reports it again.</source>
        <translation>收不到位姿：未采集。请等机械臂重新上报。</translation>
    </message>
    <message>
        <source>The poses are too much alike: the condition is {value}, at most {maximum} is possible. The flange&apos;s {axis} axis has pointed {turned}° apart at most; turn it further, by {wanted}° or more.</source>
        <translation>各位姿过于相似：条件数为 {value}，最大允许 {maximum}。法兰 {axis} 轴的指向最多相差 {turned}°；请再转开，{wanted}° 或更多。</translation>
    </message>
    <message>
        <source>“{name}”, {field}: {value} is not possible. Enter a figure from {minimum} to {maximum}.</source>
        <translation>“{name}”，{field}：{value} 无效。请输入 {minimum} 到 {maximum} 的数值。</translation>
    </message>
    <message>
        <source>The point is {value} mm beside the line it must be off from; at least {minimum} mm are needed. Choose a point further away.</source>
        <translation>该点距应离开的直线只有 {value} mm，至少需要 {minimum} mm。请选择更远的点。</translation>
    </message>
    <message>
        <source>Nothing is to be confirmed: the cell is in force, or there is none.</source>
        <translation>没有需要确认的：单元已生效，或没有单元。</translation>
    </message>
    <message>
        <source>The cell has nothing named “{value}”. Choose one of those in its list.</source>
        <translation>单元中没有“{value}”。请从列表中选择。</translation>
    </message>
    <message>
        <source>No cell is chosen. Choose one in the list, or enter a name and press New.</source>
        <translation>未选择单元。请在列表中选择，或输入名称后按“新建”。</translation>
    </message>
    <message>
        <source>The cell&apos;s file has format version {version}; this program reads version {known}. Update this program, or use the one that wrote it.</source>
        <translation>单元文件的格式版本为 {version}；本程序读取版本 {known}。请更新本程序，或使用写出它的程序。</translation>
    </message>
    <message>
        <source>“{value}” cannot be a name. Enter 1 to {maximum} characters without &lt; &gt; : &quot; / \ | ? *, and none of . ~ at its beginning, nor a dot or a space at its end.</source>
        <translation>“{value}”不能作名称。请输入 1 到 {maximum} 个字符，不含 &lt; &gt; : &quot; / \ | ? *，开头不为 . 或 ~，结尾不为点或空格。</translation>
    </message>
    <message>
        <source>No joint&apos;s reference is in doubt.</source>
        <translation>没有关节的零位基准存疑。</translation>
    </message>
    <message>
        <source>There is no cell “{name}”. Choose one of those in the list.</source>
        <translation>没有单元“{name}”。请从列表中选择。</translation>
    </message>
    <message>
        <source>The cell “{name}” of this adapter could not be read. Choose another one under Cell, or none.</source>
        <translation>此适配器的单元“{name}”无法读取。请在“单元”中另选一个，或不用单元。</translation>
    </message>
    <message>
        <source>The reference check is not open.</source>
        <translation>零位基准检查未打开。</translation>
    </message>
    <message>
        <source>These joints are still to be answered for: {joints}.</source>
        <translation>以下关节尚未回答：{joints}。</translation>
    </message>
    <message>
        <source>The arm moves: what its motion was checked with stays until it rests. Wait, or halt it.</source>
        <translation>机械臂在运动：在它静止之前，检查所依据的内容不变。请等待，或停住它。</translation>
    </message>
    <message>
        <source>The gripper table does not rise: {value} mm measured at {maximum} mm asked for, but {before} mm at {minimum} mm. Measure the two once more.</source>
        <translation>夹爪校准表不是递增的：指令 {maximum} mm 时测得 {value} mm，而指令 {minimum} mm 时测得 {before} mm。请重新测量这两组。</translation>
    </message>
    <message>
        <source>The cell could not be written to {path}: {text}. It holds until the program ends; export it to another folder.</source>
        <translation>单元无法写入 {path}：{text}。程序结束前仍有效；请导出到另一个文件夹。</translation>
    </message>
    <message>
        <source>The arm would replay a way that only it knows, and the work area could not be kept. Switch the area off under Cell, or record and replay with this program.</source>
        <translation>机械臂要回放只有它自己知道的路径，无法保证工作区。请在“单元”中关闭区域，或用本程序录制和回放。</translation>
    </message>
    <message>
        <source>This adapter was last used with the cell “{name}”. See that it is the arm in front of you, then confirm the cell, or choose another one under Cell.</source>
        <translation>此适配器上次使用的单元是“{name}”。请看清面前就是那台机械臂，再确认单元，或在“单元”中另选一个。</translation>
    </message>
    <message>
        <source>“{value}” exists already in this list. Enter another name.</source>
        <translation>列表中已有“{value}”。请输入另一个名称。</translation>
    </message>
    <message>
        <source>The reference is being checked: nothing moves but what the check drives. Finish the check, or close its window.</source>
        <translation>正在检查零位基准：除检查本身驱动的关节外，一律不动。请完成检查或关闭其窗口。</translation>
    </message>
    <message>
        <source>Not there: {part} would come to {value} mm from “{name}” of the work area; {minimum} mm are kept. Move another way, or change the area under Cell.</source>
        <translation>不能去那里：{part}将到离工作区的“{name}”{value} mm 处；应保持 {minimum} mm。请换一种走法，或在“单元”中更改区域。</translation>
    </message>
    <message>
        <source>Connected as a {chosen}, but the pose it reports is that of a {fits}: paths would be wrong. Connect it as a {fits}; until then the joints can be moved one by one.</source>
        <translation>该机械臂按 {chosen} 连接，但其反馈的位姿属于 {fits}：路径会算错。请按 {fits} 重新连接；在此之前可以逐个移动关节。</translation>
    </message>
    <message>
        <source>Which identifiers the arm obeys is not proven, so it is not moved; stop and halt reach it. Set the offsets again in Linkage with the arm in standby.</source>
        <translation>机械臂在哪些标识符上接收指令尚未证实，因此不让它运动；急停和停住仍能到达。请让机械臂处于待机，在联动控制中重新设置偏移。</translation>
    </message>
</context>
<context>
    <name>ReplayEventBar</name>
    <message>
        <source>Follow the replay</source>
        <translation>跟随回放</translation>
    </message>
    <message>
        <source>Keep the event of the moment that is shown in sight</source>
        <translation>列表跟随当前回放时刻的事件</translation>
    </message>
</context>
<context>
    <name>ReplayEvents</name>
    <message>
        <source>Events of the log</source>
        <translation>日志中的事件</translation>
    </message>
    <message>
        <source>Click: show this moment</source>
        <translation>单击：跳到该时刻</translation>
    </message>
</context>
<context>
    <name>ReplayFrame</name>
    <message>
        <source>REPLAY · NOT LIVE</source>
        <translation>回放 · 非实时画面</translation>
    </message>
    <message>
        <source>Nothing can be sent from here: there is no bus behind it.</source>
        <translation>此处不能发送任何指令：背后没有总线。</translation>
    </message>
</context>
<context>
    <name>ReplayFrames</name>
    <message>
        <source>Frames around the moment that is shown</source>
        <translation>所示时刻前后的报文</translation>
    </message>
    <message>
        <source>Click: show this moment</source>
        <translation>单击：跳到该时刻</translation>
    </message>
</context>
<context>
    <name>ReplayView</name>
    <message>
        <source>arm</source>
        <translation>有机械臂</translation>
    </message>
    <message>
        <source>no arm</source>
        <translation>无机械臂</translation>
    </message>
    <message>
        <source>generation {number}</source>
        <translation>第 {number} 代</translation>
    </message>
    <message>
        <source>(as the log tells)</source>
        <translation>（由日志判定）</translation>
    </message>
    <message>
        <source>Loading: {percent} %</source>
        <translation>正在载入：{percent} %</translation>
    </message>
    <message>
        <source>Frame {number}</source>
        <translation>第 {number} 帧</translation>
    </message>
    <message>
        <source>Joint status</source>
        <translation>关节状态</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>报文</translation>
    </message>
    <message>
        <source>Whole log</source>
        <translation>全程曲线</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>3D view of the recorded arm</source>
        <translation>记录中机械臂的 3D 视图</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>ReplayWindow</name>
    <message>
        <source>Open a log</source>
        <translation>打开日志</translation>
    </message>
    <message>
        <source>CAN logs</source>
        <translation>CAN 日志</translation>
    </message>
    <message>
        <source>Reading {name}: {count} frames so far</source>
        <translation>正在读取 {name}：已读 {count} 帧</translation>
    </message>
    <message>
        <source>{count} places of the log could not be read; the rest is shown.</source>
        <translation>日志中有 {count} 处无法读取，其余部分照常显示。</translation>
    </message>
    <message>
        <source>{count} frames had an earlier time than the frame before them; this was corrected.</source>
        <translation>有 {count} 帧的时间早于前一帧，已校正。</translation>
    </message>
    <message>
        <source>The log is longer: only its first {count} frames are shown.</source>
        <translation>日志过长，只显示前 {count} 帧。</translation>
    </message>
    <message>
        <source>The disk for temporary files is full: only the first {count} frames are shown.</source>
        <translation>临时文件所在磁盘已满，只显示前 {count} 帧。</translation>
    </message>
    <message>
        <source>It contains no frames of this kind of arm.</source>
        <translation>其中没有本型机械臂的报文。</translation>
    </message>
    <message>
        <source>The log does not show which protocol the arm spoke: choose it under “Protocol” if you know.</source>
        <translation>无法判定机械臂使用哪一代协议；如果知道，请在“协议”中选择。</translation>
    </message>
    <message>
        <source>Reading {name}…</source>
        <translation>正在读取 {name}…</translation>
    </message>
    <message>
        <source>Choose a CAN log, of this program or of another one. It is shown here as if it were live; nothing can be sent.</source>
        <translation>请选择一个 CAN 日志，可由本程序或其他程序记录。它会像实时一样显示在这里，但不能发送任何指令。</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Replay – {name}</source>
        <translation>回放 – {name}</translation>
    </message>
    <message>
        <source>Choose a log…</source>
        <translation>选择日志…</translation>
    </message>
    <message>
        <source>Open another log…</source>
        <translation>打开其他日志…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>As ROS 2 messages in MCAP, as CSV or as Parquet.</source>
        <translation>导出为 MCAP（ROS 2 消息）、CSV 或 Parquet。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>ReportExport</name>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
</context>
<context>
    <name>RingCard</name>
    <message>
        <source>The last minutes, in memory</source>
        <translation>内存中的最近几分钟</translation>
    </message>
    <message>
        <source>Save by itself at a fault or a stop</source>
        <translation>发生故障或急停时自动保存</translation>
    </message>
    <message>
        <source>A few seconds after a fault or a stop, the last minutes are saved as a log. Faults that follow one another are saved together.</source>
        <translation>发生故障或急停几秒后，最近几分钟的内容会自动保存为一份日志。接连发生的故障合并保存。</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>Save what just happened</source>
        <translation>保存刚才发生的事</translation>
    </message>
    <message>
        <source>Nothing heard yet</source>
        <translation>尚未收到任何帧</translation>
    </message>
    <message>
        <source>Everything on the bus, for {minutes} minutes.</source>
        <translation>总线上的全部内容，保留 {minutes} 分钟。</translation>
    </message>
    <message>
        <source>{length} of {minutes} minutes · {frames} frames</source>
        <translation>{length}（最长 {minutes} 分钟）· {frames} 帧</translation>
    </message>
    <message>
        <source>{now} of memory, {most} at most</source>
        <translation>占用内存 {now}，最多 {most}</translation>
    </message>
</context>
<context>
    <name>RunBar</name>
    <message>
        <source>A run is under way.</source>
        <translation>正在运行。</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Continue from row {row}</source>
        <translation>从第 {row} 行继续</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>单次</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>多次</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Number of runs</source>
        <translation>运行次数</translation>
    </message>
    <message>
        <source>From row</source>
        <translation>起始行</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>单步运行</translation>
    </message>
    <message>
        <source>The recorded pace × the speed at the top, here {percent} %.</source>
        <translation>录制速度 × 顶栏速度，此处为 {percent} %。</translation>
    </message>
    <message>
        <source>The speed of each row × that at the top: {percent} from row {row} on.</source>
        <translation>每行速度 × 顶栏速度：从第 {row} 行起为 {percent}。</translation>
    </message>
    <message>
        <source>first run</source>
        <translation>首次运行</translation>
    </message>
    <message>
        <source>“{name}” is not known to have run: the speed at the top is lowered to {percent} % as it begins.</source>
        <translation>“{name}”没有运行记录：开始时顶栏速度降到 {percent} %。</translation>
    </message>
    <message>
        <source>without its unsaved changes</source>
        <translation>不含未保存的修改</translation>
    </message>
    <message>
        <source>from here {time}</source>
        <translation>从当前位置起 {time}</translation>
    </message>
    <message>
        <source>{time} a run</source>
        <translation>每次 {time}</translation>
    </message>
    <message>
        <source>at {percent} % ≈ {time}</source>
        <translation>{percent} % 时 ≈ {time}</translation>
    </message>
    <message>
        <source>Checks it and runs it</source>
        <translation>检查后运行</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The first sample is approached at {percent} %.</source>
        <translation>先以 {percent} % 运动到第一个采样点。</translation>
    </message>
    <message>
        <source>first run: lowered to {percent} %</source>
        <translation>首次运行：速度降为 {percent} %</translation>
    </message>
    <message>
        <source>Step by step it takes as long as the operator.</source>
        <translation>逐点运行时，时长取决于操作者。</translation>
    </message>
</context>
<context>
    <name>RunEstimate</name>
    <message>
        <source>An estimate, from where the arm stands. A check tells it exactly.</source>
        <translation>估计值，从机械臂当前位置算起。检查后得到准确时间。</translation>
    </message>
    <message>
        <source>An estimate, from the first point to the last.</source>
        <translation>估计值，从第一点到最后一点。</translation>
    </message>
    <message>
        <source>An estimate, without the way to the first point. A check tells it exactly.</source>
        <translation>估计值，不含到第一点的路程。检查后显示准确值。</translation>
    </message>
    <message>
        <source>How long it takes is not known: the arm cannot reach a point or go a way, or there are too many points. A check tells more.</source>
        <translation>时长未知：机械臂到不了某个点或走不了某段路径，或者点太多。检查会给出详情。</translation>
    </message>
</context>
<context>
    <name>RunStrip</name>
    <message>
        <source>cycle {cycle} of {cycles}</source>
        <translation>第 {cycle}/{cycles} 次</translation>
    </message>
    <message>
        <source>{time} left</source>
        <translation>剩余 {time}</translation>
    </message>
    <message>
        <source>paused: raise the speed at the top, then hold “Continue” for 1 s</source>
        <translation>已暂停：请先在顶栏调高速度，再按住“继续”1 秒</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>dwelling</source>
        <translation>停留中</translation>
    </message>
    <message>
        <source>coming to rest</source>
        <translation>正在停下</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>The run waits until it is continued. The Pause key of the keyboard stays the emergency stop.</source>
        <translation>轨迹暂停，直到按住“继续”。键盘上的 Pause 键仍是急停。</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>End run</source>
        <translation>结束运行</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Puts this line away; the run is over.</source>
        <translation>收起此行；运行已结束。</translation>
    </message>
    <message>
        <source>point {row} of {count}</source>
        <translation>第 {row}/{count} 点</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>运行进度</translation>
    </message>
    <message>
        <source>paused: hold “Continue” for 1 s</source>
        <translation>已暂停：按住“继续”1 秒</translation>
    </message>
    <message>
        <source>{done} of the recording</source>
        <translation>已运行录制的 {done}</translation>
    </message>
    <message>
        <source>{done} of the inspection</source>
        <translation>已完成巡检的 {done}</translation>
    </message>
    <message>
        <source>speed {percent}</source>
        <translation>速度 {percent}</translation>
    </message>
    <message>
        <source>speed {percent}, tool ≤ {speed}</source>
        <translation>速度 {percent}，工具 ≤ {speed}</translation>
    </message>
    <message>
        <source>waiting: press “Next step”</source>
        <translation>等待中：请按“下一步”</translation>
    </message>
    <message>
        <source>ended early</source>
        <translation>提前结束</translation>
    </message>
    <message>
        <source>ended by the emergency stop</source>
        <translation>因急停结束</translation>
    </message>
</context>
<context>
    <name>SaveButton</name>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>SaveQuestion</name>
    <message>
        <source>Changes are not saved</source>
        <translation>修改未保存</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放弃修改</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>SendBox</name>
    <message>
        <source>Sent: {frame}.</source>
        <translation>已发送：{frame}。</translation>
    </message>
    <message>
        <source>A frame sent by hand is only checked for its form, and counts as another program&apos;s: any motion of this program ends.</source>
        <translation>手动发送的帧只检查格式，并按其他程序的指令处理：本程序正在进行的运动会结束。</translation>
    </message>
    <message>
        <source>Send by hand</source>
        <translation>手动发送</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Send nothing more; it also locks by itself after a minute</source>
        <translation>不再发送；一分钟后也会自动锁定</translation>
    </message>
    <message>
        <source>ID, hex</source>
        <translation>ID，十六进制</translation>
    </message>
    <message>
        <source>Identifier of the frame, hexadecimal</source>
        <translation>帧 ID，十六进制</translation>
    </message>
    <message>
        <source>Data, hex: 01 00 00 00 …</source>
        <translation>数据，十六进制：01 00 00 00 …</translation>
    </message>
    <message>
        <source>Data of the frame, hexadecimal</source>
        <translation>帧数据，十六进制</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Hold to send</source>
        <translation>按住发送</translation>
    </message>
</context>
<context>
    <name>Sender</name>
    <message>
        <source>arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>this program</source>
        <translation>本程序</translation>
    </message>
    <message>
        <source>another host</source>
        <translation>其他程序</translation>
    </message>
    <message>
        <source>another arm</source>
        <translation>另一台机械臂</translation>
    </message>
    <message>
        <source>adapter</source>
        <translation>适配器</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>leader arm</source>
        <translation>主臂</translation>
    </message>
</context>
<context>
    <name>SessionColumn</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Begun</source>
        <translation>开始时间</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>E-stops</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
</context>
<context>
    <name>SessionKind</name>
    <message>
        <source>recorded</source>
        <translation>手动开始</translation>
    </message>
    <message>
        <source>by armui record</source>
        <translation>由 armui record 记录</translation>
    </message>
    <message>
        <source>saved from memory</source>
        <translation>从内存保存</translation>
    </message>
    <message>
        <source>saved at a fault</source>
        <translation>故障时自动保存</translation>
    </message>
    <message>
        <source>saved at a stop</source>
        <translation>急停时自动保存</translation>
    </message>
</context>
<context>
    <name>SessionState</name>
    <message>
        <source>under way</source>
        <translation>正在写入</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>完整</translation>
    </message>
    <message>
        <source>cut off: readable to its last second</source>
        <translation>中断：可读取至最后一秒</translation>
    </message>
    <message>
        <source>ended early: {text}</source>
        <translation>提前结束：{text}</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>its description file cannot be read: {text}</source>
        <translation>旁边的说明文件无法读取：{text}</translation>
    </message>
</context>
<context>
    <name>SessionsPage</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Replay another log…</source>
        <translation>回放其他日志…</translation>
    </message>
    <message>
        <source>Any CAN log, also of another program, is shown as if it were live.</source>
        <translation>任何 CAN 日志（包括其他程序的）都可以像实时一样显示。</translation>
    </message>
    <message>
        <source>This computer opens no file manager. The folder is {folder}.</source>
        <translation>本机无法打开文件管理器。文件夹是：{folder}。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>As ROS 2 messages in MCAP, as CSV or as Parquet.</source>
        <translation>导出为 MCAP（ROS 2 消息）、CSV 或 Parquet。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>改名</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Moves the log into the folder “deleted” beside the others.</source>
        <translation>将日志移到同一位置的“deleted”文件夹中。</translation>
    </message>
    <message>
        <source>Show in the file manager</source>
        <translation>在文件管理器中显示</translation>
    </message>
    <message>
        <source>No logs yet. Start a log, or save what just happened: both can be replayed here and opened in other CAN tools.</source>
        <translation>还没有日志。可以开始写日志，或保存刚才发生的事：两者都能在此回放，也能用其他 CAN 工具打开。</translation>
    </message>
    <message>
        <source>Choose one log in the list first.</source>
        <translation>请先在列表中选择一份日志。</translation>
    </message>
    <message>
        <source>Moved to {folder}. It can be moved back from there.</source>
        <translation>已移到 {folder}，可以从那里移回。</translation>
    </message>
</context>
<context>
    <name>Setting</name>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Jog step</source>
        <translation>点动步长</translation>
    </message>
    <message>
        <source>Robot description (URDF)</source>
        <translation>机器人模型（URDF）</translation>
    </message>
    <message>
        <source>Tool centre point</source>
        <translation>工具中心点</translation>
    </message>
    <message>
        <source>Mounting of each arm</source>
        <translation>各机械臂的安装方式</translation>
    </message>
    <message>
        <source>Park position of each arm</source>
        <translation>各机械臂的停放位</translation>
    </message>
    <message>
        <source>Stop again if another host undoes an emergency stop</source>
        <translation>急停被其他程序解除时自动再次急停</translation>
    </message>
    <message>
        <source>This is always reported as a fault. With this setting the stop is also sent again by itself.</source>
        <translation>这种情况总会作为故障提示。勾选后还会自动再次发送急停。</translation>
    </message>
    <message>
        <source>Motions end at a lowest height of the fingertip</source>
        <translation>运动止于末端的最低高度</translation>
    </message>
    <message>
        <source>Above the floor: the plane the arm stands on, or the room&apos;s floor where the cell says under Base how the arm stands. 0 mm is the floor, negative is below it. Every motion keeps to it: jogs, steps, single motions, runs and replays. An arm that is lower may only go up.</source>
        <translation>高于地面：机械臂所在的平面，或单元“底座”中给出的房间地面。0 mm 即地面，负值在其下。所有运动都遵守：点动、步进、单次运动、轨迹和回放。已低于它的机械臂只能向上。</translation>
    </message>
    <message>
        <source>Folder of the logs</source>
        <translation>日志的文件夹</translation>
    </message>
    <message>
        <source>Format of the logs</source>
        <translation>日志的格式</translation>
    </message>
    <message>
        <source>Size at which a new file is begun</source>
        <translation>日志的分卷大小</translation>
    </message>
    <message>
        <source>Saving at faults and stops</source>
        <translation>故障或急停时自动保存</translation>
    </message>
    <message>
        <source>View of the 3D picture</source>
        <translation>3D 画面的视角</translation>
    </message>
    <message>
        <source>3D picture without perspective</source>
        <translation>3D 画面的平行投影</translation>
    </message>
    <message>
        <source>Tool frame in the 3D picture</source>
        <translation>3D 画面中的工具坐标系</translation>
    </message>
    <message>
        <source>Tool trail in the 3D picture</source>
        <translation>3D 画面中的末端轨迹</translation>
    </message>
    <message>
        <source>Jogging by gamepad</source>
        <translation>手柄点动</translation>
    </message>
    <message>
        <source>What a gamepad moves</source>
        <translation>手柄控制的对象</translation>
    </message>
    <message>
        <source>One axis at a time by gamepad</source>
        <translation>手柄一次只动一个轴</translation>
    </message>
    <message>
        <source>Buttons of the gamepads</source>
        <translation>手柄按键</translation>
    </message>
    <message>
        <source>Local interface</source>
        <translation>本地接口</translation>
    </message>
    <message>
        <source>Scripts and other programs of yours may read the arm, and ask you for it. Other users of this computer and other computers cannot.</source>
        <translation>您的脚本和其他程序可读取机械臂的状态，并向您申请操作。本机的其他用户和其他电脑不能使用。</translation>
    </message>
    <message>
        <source>Live stream for Foxglove, on port</source>
        <translation>Foxglove 实时数据流，端口</translation>
    </message>
    <message>
        <source>Shows what is measured, live, in Foxglove and other programs that speak its WebSocket protocol. They only watch. Every program, web page and user of this computer can.</source>
        <translation>在 Foxglove 和其他支持其 WebSocket 协议的程序中实时显示测得的数据。它们只能观看。本机的任何程序、网页和用户都能观看。</translation>
    </message>
    <message>
        <source>Port of the live stream</source>
        <translation>实时数据流的端口</translation>
    </message>
    <message>
        <source>Live stream for other computers, too</source>
        <translation>实时数据流也供其他电脑观看</translation>
    </message>
    <message>
        <source>Everybody in the network can watch then, without a password and unencrypted.</source>
        <translation>打开后网络中的任何人都能观看，没有密码，也不加密。</translation>
    </message>
    <message>
        <source>Models of the arms</source>
        <translation>机械臂型号</translation>
    </message>
    <message>
        <source>References of the arms</source>
        <translation>各机械臂的零位基准</translation>
    </message>
    <message>
        <source>Cells of the arms</source>
        <translation>各机械臂的单元</translation>
    </message>
</context>
<context>
    <name>SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Shown at once; its own font for quotation marks follows at the next start.</source>
        <translation>立即生效；对应的字体（引号的宽窄）在下次启动后生效。</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>{minimum}° to {maximum}°: how far − and + move a joint</source>
        <translation>{minimum}° 至 {maximum}°，即每按一次 − 或 + 关节转动的角度</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>Use the built-in one</source>
        <translation>使用内置模型</translation>
    </message>
    <message>
        <source>Local interface…</source>
        <translation>本地接口…</translation>
    </message>
    <message>
        <source>Diagnosis…</source>
        <translation>诊断…</translation>
    </message>
    <message>
        <source>About this arm…</source>
        <translation>关于本机械臂…</translation>
    </message>
    <message>
        <source>Simulated faults…</source>
        <translation>仿真故障…</translation>
    </message>
    <message>
        <source>On: for your scripts</source>
        <translation>开：供您的脚本使用</translation>
    </message>
    <message>
        <source>The built-in robot description is in use.</source>
        <translation>当前使用的就是内置模型。</translation>
    </message>
    <message>
        <source>Choose a robot description</source>
        <translation>选择机器人模型</translation>
    </message>
    <message>
        <source>Robot description</source>
        <translation>机器人模型</translation>
    </message>
    <message>
        <source>Gamepad, SpaceMouse</source>
        <translation>手柄、SpaceMouse</translation>
    </message>
    <message>
        <source>Gamepad…</source>
        <translation>手柄…</translation>
    </message>
    <message>
        <source>On: jogs the arm</source>
        <translation>已开启：可以点动机械臂</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>Built-in model of the {model}</source>
        <translation>{model} 内置模型</translation>
    </message>
    <message>
        <source>About armui…</source>
        <translation>关于 armui…</translation>
    </message>
</context>
<context>
    <name>SharedUseBanner</name>
    <message>
        <source>Another program has this library open, too ({names}). What it saves appears in this list. Do not edit the same trajectory in both.</source>
        <translation>另一程序也打开了此轨迹库（{names}）。它保存的内容会出现在此列表中。请勿在两个程序中编辑同一条轨迹。</translation>
    </message>
</context>
<context>
    <name>Shortcut</name>
    <message>
        <source>Command palette: find every function by its name</source>
        <translation>命令面板：按名称查找任何功能</translation>
    </message>
    <message>
        <source>Faster: run or motion</source>
        <translation>加速：运行或运动</translation>
    </message>
    <message>
        <source>Begin or end an episode of the log</source>
        <translation>开始或结束日志的片段</translation>
    </message>
    <message>
        <source>Discard the last episode</source>
        <translation>弃用最后一个片段</translation>
    </message>
    <message>
        <source>This list</source>
        <translation>本列表</translation>
    </message>
    <message>
        <source>Pause, continue</source>
        <translation>暂停、继续</translation>
    </message>
    <message>
        <source>Copy the chosen rows</source>
        <translation>复制所选行</translation>
    </message>
    <message>
        <source>Play, pause</source>
        <translation>播放、暂停</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>后退一帧</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>前进一帧</translation>
    </message>
    <message>
        <source>Halt: ends any motion, the motors keep their power</source>
        <translation>停住：结束任何运动，电机保持通电</translation>
    </message>
    <message>
        <source>Slower: run or motion</source>
        <translation>减速：运行或运动</translation>
    </message>
    <message>
        <source>To the next control; with Shift to the one before</source>
        <translation>到下一个控件；加 Shift 到上一个</translation>
    </message>
    <message>
        <source>Close the dialog</source>
        <translation>关闭对话框</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>旋转视角</translation>
    </message>
    <message>
        <source>Zoom in and out</source>
        <translation>放大、缩小</translation>
    </message>
    <message>
        <source>The first view again</source>
        <translation>还原最初的视角</translation>
    </message>
    <message>
        <source>With Space held: J1 to J6 up, down</source>
        <translation>按住空格：J1 至 J6 增、减</translation>
    </message>
    <message>
        <source>With Space held: X, Y, Z of the tool</source>
        <translation>按住空格：末端 X、Y、Z</translation>
    </message>
    <message>
        <source>With Space held: RX, RY, RZ of the tool</source>
        <translation>按住空格：末端 RX、RY、RZ</translation>
    </message>
    <message>
        <source>On the timeline: through the recording</source>
        <translation>在时间轴上：在日志中前后移动</translation>
    </message>
    <message>
        <source>Help, at the place where you are</source>
        <translation>使用帮助，打开当前所在处的章节</translation>
    </message>
</context>
<context>
    <name>ShortcutList</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>快捷键</translation>
    </message>
</context>
<context>
    <name>SideMenu</name>
    <message>
        <source>Motion control</source>
        <translation>运动控制</translation>
    </message>
    <message>
        <source>Cartesian</source>
        <translation>末端控制</translation>
    </message>
    <message>
        <source>Light control</source>
        <translation>灯光控制</translation>
    </message>
    <message>
        <source>Linkage control</source>
        <translation>联动控制</translation>
    </message>
    <message>
        <source>Joint settings</source>
        <translation>关节设置</translation>
    </message>
    <message>
        <source>End speed limits</source>
        <translation>配速设置</translation>
    </message>
    <message>
        <source>Collision level</source>
        <translation>碰撞等级</translation>
    </message>
    <message>
        <source>Motor settings</source>
        <translation>电机设置</translation>
    </message>
    <message>
        <source>Gripper control</source>
        <translation>夹爪控制</translation>
    </message>
    <message>
        <source>Gripper settings</source>
        <translation>夹爪设置</translation>
    </message>
    <message>
        <source>End load</source>
        <translation>末端负载</translation>
    </message>
    <message>
        <source>Drag teaching</source>
        <translation>示教</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Arm settings</source>
        <translation>机械臂设置</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>工作</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>观察</translation>
    </message>
</context>
<context>
    <name>SignalName</name>
    <message>
        <source>Acceleration valid</source>
        <translation>加速度有效</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Angular acceleration</source>
        <translation>角加速度</translation>
    </message>
    <message>
        <source>Angular speed</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Supply current</source>
        <translation>母线电流</translation>
    </message>
    <message>
        <source>Clear error</source>
        <translation>清除错误</translation>
    </message>
    <message>
        <source>Collision protection</source>
        <translation>碰撞保护</translation>
    </message>
    <message>
        <source>Control mode</source>
        <translation>控制模式</translation>
    </message>
    <message>
        <source>Offset of the commands</source>
        <translation>控制指令偏移</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>Check sum (CRC16)</source>
        <translation>校验（CRC16）</translation>
    </message>
    <message>
        <source>Check sum (4 bits)</source>
        <translation>校验（4 位）</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Driver fault</source>
        <translation>驱动器错误</translation>
    </message>
    <message>
        <source>Driver too hot</source>
        <translation>驱动器过温</translation>
    </message>
    <message>
        <source>Driver temperature</source>
        <translation>驱动器温度</translation>
    </message>
    <message>
        <source>Dwell time</source>
        <translation>停留时间</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Feedback of the end&apos;s motion</source>
        <translation>末端运动反馈</translation>
    </message>
    <message>
        <source>Offset of the feedback</source>
        <translation>反馈指令偏移</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦系数</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Zero found</source>
        <translation>已回零</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>应答对象</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Kd</source>
        <translation>Kd</translation>
    </message>
    <message>
        <source>Kp</source>
        <translation>Kp</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>灯珠</translation>
    </message>
    <message>
        <source>Linear acceleration</source>
        <translation>线加速度</translation>
    </message>
    <message>
        <source>Linear speed</source>
        <translation>线速度</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>Load valid</source>
        <translation>负载有效</translation>
    </message>
    <message>
        <source>Highest acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>最大角度</translation>
    </message>
    <message>
        <source>Highest angular acceleration</source>
        <translation>最大角加速度</translation>
    </message>
    <message>
        <source>Highest angular speed</source>
        <translation>最大角速度</translation>
    </message>
    <message>
        <source>Highest linear acceleration</source>
        <translation>最大线加速度</translation>
    </message>
    <message>
        <source>Highest linear speed</source>
        <translation>最大线速度</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>最小角度</translation>
    </message>
    <message>
        <source>Follow mode</source>
        <translation>跟随模式</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Motor too hot</source>
        <translation>电机过温</translation>
    </message>
    <message>
        <source>Motor temperature</source>
        <translation>电机温度</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>安装方式</translation>
    </message>
    <message>
        <source>Move mode</source>
        <translation>运动模式</translation>
    </message>
    <message>
        <source>Index of the name</source>
        <translation>名称索引</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>开度</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>查询</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Factory reset</source>
        <translation>恢复出厂</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Sensor fault</source>
        <translation>传感器异常</translation>
    </message>
    <message>
        <source>Set zero</source>
        <translation>设置零点</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed percentage</source>
        <translation>速度百分比</translation>
    </message>
    <message>
        <source>Stall protection</source>
        <translation>堵转保护</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>Offset of what a leader sends</source>
        <translation>主臂发送的指令偏移</translation>
    </message>
    <message>
        <source>Teaching command</source>
        <translation>示教指令</translation>
    </message>
    <message>
        <source>Range of the handle</source>
        <translation>手柄行程系数</translation>
    </message>
    <message>
        <source>Teaching state</source>
        <translation>示教状态</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>Trajectory command</source>
        <translation>轨迹指令</translation>
    </message>
    <message>
        <source>Trajectory point</source>
        <translation>轨迹点</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>传输</translation>
    </message>
    <message>
        <source>Voltage too low</source>
        <translation>电压过低</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>零点</translation>
    </message>
    <message>
        <source>J{joint} limit</source>
        <translation>J{joint} 限位</translation>
    </message>
    <message>
        <source>J{joint} communication</source>
        <translation>J{joint} 通信</translation>
    </message>
    <message>
        <source>Byte {place}</source>
        <translation>字节 {place}</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>Deceleration</source>
        <translation>减速度</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Given as</source>
        <translation>表示方式</translation>
    </message>
    <message>
        <source>Position loop Kp</source>
        <translation>位置环 Kp</translation>
    </message>
    <message>
        <source>Target position</source>
        <translation>目标位置</translation>
    </message>
    <message>
        <source>Profile speed</source>
        <translation>规划速度</translation>
    </message>
    <message>
        <source>Speed loop Ki</source>
        <translation>速度环 Ki</translation>
    </message>
    <message>
        <source>Speed loop Kp</source>
        <translation>速度环 Kp</translation>
    </message>
    <message>
        <source>Target speed</source>
        <translation>目标速度</translation>
    </message>
    <message>
        <source>Zero learning</source>
        <translation>零点学习</translation>
    </message>
</context>
<context>
    <name>SignalWord</name>
    <message>
        <source>Abort</source>
        <translation>终止</translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation>加速度限制</translation>
    </message>
    <message>
        <source>All joints</source>
        <translation>全部关节</translation>
    </message>
    <message>
        <source>All lamps</source>
        <translation>所有灯珠</translation>
    </message>
    <message>
        <source>Angle and speed limits</source>
        <translation>角度与速度限制</translation>
    </message>
    <message>
        <source>Beyond limit</source>
        <translation>超限</translation>
    </message>
    <message>
        <source>Brake resistor too hot</source>
        <translation>释放电阻过温</translation>
    </message>
    <message>
        <source>CAN control</source>
        <translation>CAN 指令控制</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>清除所有轨迹</translation>
    </message>
    <message>
        <source>Clear current</source>
        <translation>清除当前轨迹</translation>
    </message>
    <message>
        <source>Clear error</source>
        <translation>清除错误</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>Collision levels</source>
        <translation>碰撞防护等级</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>失能</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>已失能</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>空载</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>End</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>End limits</source>
        <translation>末端限制</translation>
    </message>
    <message>
        <source>End limits to factory</source>
        <translation>末端限制恢复出厂</translation>
    </message>
    <message>
        <source>End of trajectory</source>
        <translation>轨迹结束</translation>
    </message>
    <message>
        <source>Ethernet control</source>
        <translation>以太网控制</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>异常</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>满载</translation>
    </message>
    <message>
        <source>Get current</source>
        <translation>获取当前轨迹</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>半载</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>Joint brake closed</source>
        <translation>关节抱闸未打开</translation>
    </message>
    <message>
        <source>Joint communication fault</source>
        <translation>关节通信异常</translation>
    </message>
    <message>
        <source>Joint limits to factory</source>
        <translation>关节限制恢复出厂</translation>
    </message>
    <message>
        <source>Joint status abnormal</source>
        <translation>关节状态异常</translation>
    </message>
    <message>
        <source>Large gripper</source>
        <translation>大夹爪</translation>
    </message>
    <message>
        <source>Leave silence</source>
        <translation>解除静默</translation>
    </message>
    <message>
        <source>Leave unchanged</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Linked teaching input</source>
        <translation>联动示教输入</translation>
    </message>
    <message>
        <source>MIT</source>
        <translation>MIT</translation>
    </message>
    <message>
        <source>MOVE C</source>
        <translation>MOVE C</translation>
    </message>
    <message>
        <source>MOVE CPV</source>
        <translation>MOVE CPV</translation>
    </message>
    <message>
        <source>MOVE J</source>
        <translation>MOVE J</translation>
    </message>
    <message>
        <source>MOVE L</source>
        <translation>MOVE L</translation>
    </message>
    <message>
        <source>MOVE M</source>
        <translation>MOVE M</translation>
    </message>
    <message>
        <source>MOVE P</source>
        <translation>MOVE P</translation>
    </message>
    <message>
        <source>Main controller too hot</source>
        <translation>主控过温</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>中间点</translation>
    </message>
    <message>
        <source>Motion output</source>
        <translation>运动输出臂</translation>
    </message>
    <message>
        <source>Move to start</source>
        <translation>运动到起点</translation>
    </message>
    <message>
        <source>No</source>
        <translation>否</translation>
    </message>
    <message>
        <source>No action</source>
        <translation>无动作</translation>
    </message>
    <message>
        <source>No change</source>
        <translation>不变</translation>
    </message>
    <message>
        <source>No offset</source>
        <translation>无偏移</translation>
    </message>
    <message>
        <source>No solution</source>
        <translation>无解</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Not given</source>
        <translation>未指定</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>未到达</translation>
    </message>
    <message>
        <source>Not set</source>
        <translation>未设置</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Offline trajectory</source>
        <translation>离线轨迹</translation>
    </message>
    <message>
        <source>Offset 0x10</source>
        <translation>偏移 0x10</translation>
    </message>
    <message>
        <source>Offset 0x20</source>
        <translation>偏移 0x20</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开启</translation>
    </message>
    <message>
        <source>On the left side</source>
        <translation>侧装（左）</translation>
    </message>
    <message>
        <source>On the right side</source>
        <translation>侧装（右）</translation>
    </message>
    <message>
        <source>Other fault</source>
        <translation>其他异常</translation>
    </message>
    <message>
        <source>Overspeed while teaching</source>
        <translation>拖动示教超速</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Position-velocity</source>
        <translation>位置速度模式</translation>
    </message>
    <message>
        <source>Reached</source>
        <translation>已到达</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>已接收</translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation>遥控器控制</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Run recording</source>
        <translation>执行示教轨迹</translation>
    </message>
    <message>
        <source>Send again</source>
        <translation>请重发</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>已设置</translation>
    </message>
    <message>
        <source>Set zero</source>
        <translation>设置零点</translation>
    </message>
    <message>
        <source>Silence for controller upgrade</source>
        <translation>主控升级静默</translation>
    </message>
    <message>
        <source>Silence for driver upgrade</source>
        <translation>驱动器升级静默</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>奇异点</translation>
    </message>
    <message>
        <source>Small gripper</source>
        <translation>小夹爪</translation>
    </message>
    <message>
        <source>Standby</source>
        <translation>待机</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>开始示教记录</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>结束示教记录</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Target beyond limit</source>
        <translation>目标超限</translation>
    </message>
    <message>
        <source>Teaching</source>
        <translation>示教</translation>
    </message>
    <message>
        <source>Teaching input</source>
        <translation>示教输入臂</translation>
    </message>
    <message>
        <source>Teaching paused</source>
        <translation>示教暂停</translation>
    </message>
    <message>
        <source>Teaching recording</source>
        <translation>示教记录</translation>
    </message>
    <message>
        <source>Teaching running</source>
        <translation>示教执行</translation>
    </message>
    <message>
        <source>Teaching setting</source>
        <translation>示教设置</translation>
    </message>
    <message>
        <source>Trajectory index</source>
        <translation>轨迹索引</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>传输</translation>
    </message>
    <message>
        <source>Transfer ends</source>
        <translation>传输结束</translation>
    </message>
    <message>
        <source>Unchanged</source>
        <translation>不变</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>有效</translation>
    </message>
    <message>
        <source>WiFi control</source>
        <translation>Wi-Fi 控制</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>未超限</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>Both to zero</source>
        <translation>主从臂均回零</translation>
    </message>
    <message>
        <source>Deceleration</source>
        <translation>减速度</translation>
    </message>
    <message>
        <source>Drag assistance</source>
        <translation>拖动助力</translation>
    </message>
    <message>
        <source>Leader and follower</source>
        <translation>恢复主从</translation>
    </message>
    <message>
        <source>Leader to zero</source>
        <translation>主臂回零</translation>
    </message>
    <message>
        <source>MOVE M from 1.8-8</source>
        <translation>MOVE M（1.8-8 起）</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>开度</translation>
    </message>
    <message>
        <source>Position Kp</source>
        <translation>位置环 Kp</translation>
    </message>
    <message>
        <source>Position target</source>
        <translation>位置目标</translation>
    </message>
    <message>
        <source>Profile speed</source>
        <translation>规划速度</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Speed Ki</source>
        <translation>速度环 Ki</translation>
    </message>
    <message>
        <source>Speed Kp</source>
        <translation>速度环 Kp</translation>
    </message>
    <message>
        <source>Speed target</source>
        <translation>速度目标</translation>
    </message>
    <message>
        <source>Upside down</source>
        <translation>水平倒装</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Zero learning</source>
        <translation>零点学习</translation>
    </message>
</context>
<context>
    <name>SimulatedFault</name>
    <message>
        <source>Motor too hot</source>
        <translation>电机过温</translation>
    </message>
    <message>
        <source>Driver too hot</source>
        <translation>驱动器过温</translation>
    </message>
    <message>
        <source>Overcurrent</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>Joint not reached</source>
        <translation>关节通信异常</translation>
    </message>
    <message>
        <source>Encoder fails</source>
        <translation>编码器故障</translation>
    </message>
    <message>
        <source>Driver fails</source>
        <translation>驱动器故障</translation>
    </message>
    <message>
        <source>Joint blocked</source>
        <translation>关节堵转</translation>
    </message>
    <message>
        <source>Collision (40 N·m)</source>
        <translation>碰撞（40 N·m）</translation>
    </message>
    <message>
        <source>Joint turns stiffly</source>
        <translation>关节卡滞</translation>
    </message>
    <message>
        <source>Joint runs hot</source>
        <translation>关节过热</translation>
    </message>
    <message>
        <source>Slips by 5°, seen at resume</source>
        <translation>滑移 5°，解除急停时显示</translation>
    </message>
    <message>
        <source>Reference lost, until release</source>
        <translation>丢失基准，解除急停后正常</translation>
    </message>
    <message>
        <source>Limits 0xFFFF, until reset</source>
        <translation>限位 0xFFFF，重设后正常</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>断电</translation>
    </message>
    <message>
        <source>Undervoltage (18 V)</source>
        <translation>欠压（18 V）</translation>
    </message>
    <message>
        <source>Feedback silent</source>
        <translation>停止反馈</translation>
    </message>
    <message>
        <source>Bus off</source>
        <translation>总线关闭（bus-off）</translation>
    </message>
    <message>
        <source>Adapter deaf</source>
        <translation>适配器收不到</translation>
    </message>
    <message>
        <source>10 % of frames lost</source>
        <translation>丢失 10 % 的帧</translation>
    </message>
    <message>
        <source>Frames 50 ms late</source>
        <translation>帧延迟 50 ms</translation>
    </message>
    <message>
        <source>Foreign frames, 100/s</source>
        <translation>外来帧，每秒 100 个</translation>
    </message>
</context>
<context>
    <name>SpeedControl</name>
    <message>
        <source>The speed percentage the arm reports</source>
        <translation>机械臂反馈的速度百分比</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Speed at most, for a motion of the present mode</source>
        <translation>当前运动模式下的最大速度</translation>
    </message>
    <message>
        <source>The speed of everything, 0–100 %: of the arm&apos;s highest, and in a run of each point&apos;s or the recorded one. 0 % holds a run back. Slower {slower}, faster {faster}. A motion measured to be more than 1.5 times as fast as it was told is ended.</source>
        <translation>所有运动的速度，0–100 %：相对机械臂最大速度；运行时相对各点或录制的速度。0 % 使运行暂停。降速 {slower}，提速 {faster}。测得速度超过指令的 1.5 倍时，终止该运动。</translation>
    </message>
    <message>
        <source>Speed percentage</source>
        <translation>速度百分比</translation>
    </message>
    <message>
        <source>Speed percentage reported by the arm</source>
        <translation>机械臂反馈的速度百分比</translation>
    </message>
</context>
<context>
    <name>StatusBar</name>
    <message>
        <source>Control: {mode}</source>
        <translation>控制: {mode}</translation>
    </message>
    <message>
        <source>Status: {status}</source>
        <translation>状态: {status}</translation>
    </message>
    <message>
        <source>No communication: {joints}</source>
        <translation>通信异常: {joints}</translation>
    </message>
    <message>
        <source>Beyond limit: {joints}</source>
        <translation>超限位: {joints}</translation>
    </message>
    <message>
        <source>Last event</source>
        <translation>最近事件</translation>
    </message>
    <message>
        <source>{mode} by another program</source>
        <translation>{mode}（另一程序）</translation>
    </message>
</context>
<context>
    <name>StepBox</name>
    <message>
        <source>Continuous</source>
        <translation>连续</translation>
    </message>
</context>
<context>
    <name>StopButton</name>
    <message>
        <source>Stop unconfirmed</source>
        <translation>急停未确认</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>急停中…</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>Waiting for the arm</source>
        <translation>等待机械臂确认</translation>
    </message>
    <message>
        <source>Hold the arm</source>
        <translation>请扶住机械臂</translation>
    </message>
    <message>
        <source>Stop outstanding</source>
        <translation>急停未完成</translation>
    </message>
    <message>
        <source>The arm has taken the emergency stop; a press sends it again. Release stands in the line of the next step above the panel: hold the arm before.</source>
        <translation>机械臂已执行急停；再按会再次发送急停。解除急停的按钮在面板上方的下一步提示行中：请先扶住机械臂。</translation>
    </message>
    <message>
        <source>Ends at once whatever drives the arm, and takes the power from its joints: they are only damped, and the arm sinks. Hold it. Key: {key}</source>
        <translation>立即切断一切驱动，关节失去力矩，只有阻尼：机械臂会下沉，请扶住。快捷键：{key}</translation>
    </message>
    <message>
        <source>The arm is at rest</source>
        <translation>机械臂已静止</translation>
    </message>
    <message>
        <source>Press to send it</source>
        <translation>按下即发送</translation>
    </message>
</context>
<context>
    <name>TargetDrag</name>
    <message>
        <source>Preview of the target: it has not been sent</source>
        <translation>目标预览：尚未发送</translation>
    </message>
    <message>
        <source>The ghost shows where the arm would touch</source>
        <translation>虚影为机械臂将碰到处的位姿</translation>
    </message>
    <message>
        <source>The ghost shows where Move inside brings the arm</source>
        <translation>虚影为“回到限位内”将到达的位姿</translation>
    </message>
    <message>
        <source>Simulated arm in drag teaching: lead it by the handles in the picture, as by hand</source>
        <translation>仿真机械臂处于拖动示教：在画面中拖动手柄即可用鼠标牵引</translation>
    </message>
</context>
<context>
    <name>Targets</name>
    <message>
        <source>Joint targets</source>
        <translation>关节目标</translation>
    </message>
    <message>
        <source>Pose targets</source>
        <translation>位姿目标</translation>
    </message>
    <message>
        <source>MIT commands</source>
        <translation>MIT 指令</translation>
    </message>
    <message>
        <source>Gripper commands</source>
        <translation>夹爪指令</translation>
    </message>
</context>
<context>
    <name>Teaching</name>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Start of recording (drag teaching on)</source>
        <translation>开始示教记录（进入拖动示教模式）</translation>
    </message>
    <message>
        <source>End of recording (drag teaching off)</source>
        <translation>结束示教记录（退出拖动示教模式）</translation>
    </message>
    <message>
        <source>Replaying the taught trajectory</source>
        <translation>执行示教轨迹（拖动示教轨迹复现）</translation>
    </message>
    <message>
        <source>Replay paused</source>
        <translation>暂停执行</translation>
    </message>
    <message>
        <source>Replay resumed</source>
        <translation>继续执行（轨迹复现继续）</translation>
    </message>
    <message>
        <source>Replay terminated</source>
        <translation>终止执行</translation>
    </message>
    <message>
        <source>Moving to the start of the trajectory</source>
        <translation>运动到轨迹起点</translation>
    </message>
    <message>
        <source>Recording ended; still in drag teaching</source>
        <translation>记录已结束，仍处于示教模式</translation>
    </message>
    <message>
        <source>No command; still in drag teaching</source>
        <translation>无命令，仍处于示教模式</translation>
    </message>
</context>
<context>
    <name>TeachingCommand</name>
    <message>
        <source>Start recording</source>
        <translation>开始示教记录</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>结束示教记录</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>执行示教轨迹</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停执行</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续执行</translation>
    </message>
    <message>
        <source>Terminate</source>
        <translation>终止执行</translation>
    </message>
    <message>
        <source>Move to start</source>
        <translation>运动到轨迹起点</translation>
    </message>
</context>
<context>
    <name>TeachingExitSteps</name>
    <message>
        <source>Stopped before the arm was led back: that does not end drag teaching. Release it in the line above the panels, then take these steps:</source>
        <translation>尚未拖回即已急停：这样不能退出拖动示教。请先在面板上方的提示行解除急停，再按以下步骤操作：</translation>
    </message>
    <message>
        <source>End what is under way; lead every joint near its zero by hand.</source>
        <translation>结束当前动作，用手将各关节拖动到零位附近。</translation>
    </message>
    <message>
        <source>Hold the arm, press “{action}”: the motors only brake, the arm sinks.</source>
        <translation>请扶住机械臂，按“{action}”：电机只起阻尼作用，机械臂会下沉。</translation>
    </message>
    <message>
        <source>Hold down “{action}”: the arm will drop, keep holding it.</source>
        <translation>按住“{action}”：机械臂会下落，请继续扶住。</translation>
    </message>
    <message>
        <source>Press “{action}”.</source>
        <translation>按“{action}”。</translation>
    </message>
    <message>
        <source>To leave drag teaching, take the steps in the line above the panels:</source>
        <translation>退出示教模式，请按面板上方的提示逐步操作：</translation>
    </message>
</context>
<context>
    <name>TeachingPanel</name>
    <message>
        <source>The arm gives way to the hand and records where it is led.</source>
        <translation>机械臂可用手拖动，并记录拖动轨迹。</translation>
    </message>
    <message>
        <source>The arm moves: keep clear.</source>
        <translation>机械臂会运动，请勿靠近。</translation>
    </message>
    <message>
        <source>Waiting for the arm: {command}</source>
        <translation>等待机械臂：{command}</translation>
    </message>
    <message>
        <source>A motion is held back: hold Continue, or give it up by Terminate.</source>
        <translation>有运动被保留：按住“继续”，或用“终止”放弃它。</translation>
    </message>
    <message>
        <source>Drag teaching</source>
        <translation>示教</translation>
    </message>
    <message>
        <source>Teaching state</source>
        <translation>示教状态</translation>
    </message>
    <message>
        <source>The teaching button on the arm works beside this panel, which follows it.</source>
        <translation>机械臂上的示教按键同样有效，本面板会跟随显示。</translation>
    </message>
    <message>
        <source>Planned trajectory</source>
        <translation>轨迹指令</translation>
    </message>
    <message>
        <source>Works on motions under way. The arm does not report it: watch the arm.</source>
        <translation>对正在进行的运动有效。机械臂不反馈此指令，请观察机械臂。</translation>
    </message>
    <message>
        <source>Drag assistance…</source>
        <translation>拖动助力…</translation>
    </message>
    <message>
        <source>How much each joint helps the hand; firmware from S-V1.8-1.</source>
        <translation>各关节拖动时的助力大小；固件 S-V1.8-1 起支持。</translation>
    </message>
    <message>
        <source>The arm will move by itself to the start of the recording it holds.</source>
        <translation>机械臂将自行运动到其所存示教轨迹的起点。</translation>
    </message>
    <message>
        <source>The arm will move by itself along the recording it holds, from where it stands.</source>
        <translation>机械臂将从当前位置自行沿其所存示教轨迹运动。</translation>
    </message>
    <message>
        <source>This program does not know its way, and has not checked it. Keep clear, the emergency stop within reach.</source>
        <translation>本程序不知道该轨迹的路径，也未作检查。请勿靠近，急停须随时可按。</translation>
    </message>
</context>
<context>
    <name>TeachingPhase</name>
    <message>
        <source>Not in drag teaching</source>
        <translation>未进入示教</translation>
    </message>
    <message>
        <source>In drag teaching, nothing under way</source>
        <translation>示教模式，无动作</translation>
    </message>
    <message>
        <source>Recording: lead the arm by hand</source>
        <translation>示教记录中，请拖动机械臂</translation>
    </message>
    <message>
        <source>Moving along the recording</source>
        <translation>正在执行示教轨迹</translation>
    </message>
    <message>
        <source>Replay paused</source>
        <translation>示教轨迹已暂停</translation>
    </message>
</context>
<context>
    <name>TimeLine</name>
    <message>
        <source>Timeline of the log</source>
        <translation>日志的时间轴</translation>
    </message>
</context>
<context>
    <name>TipByPoints</name>
    <message>
        <source>Puts the tip found in force, in the place of what was.</source>
        <translation>使求得的尖端生效，取代原有的。</translation>
    </message>
    <message>
        <source>On the X side</source>
        <translation>X 侧</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>重新采集</translation>
    </message>
    <message>
        <source>Pose {number}</source>
        <translation>位姿 {number}</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>No more than {count} poses are taken. Take one of them again.</source>
        <translation>最多采集 {count} 个位姿。请重新采集其中一个。</translation>
    </message>
    <message>
        <source>The orientation is not taken yet.</source>
        <translation>姿态尚未采集。</translation>
    </message>
    <message>
        <source>Compare what was found with what was, then press Apply the tip.</source>
        <translation>请比较求得的与原有的，再按“应用尖端”。</translation>
    </message>
    <message>
        <source>Touch the point with the side of the tool&apos;s X; press On the X side.</source>
        <translation>用工具 X 方向一侧触碰该点；再按“X 侧”。</translation>
    </message>
    <message>
        <source>it points along {axis} of the base</source>
        <translation>指向基座 {axis}</translation>
    </message>
    <message>
        <source>The tip found is in force. Start again for another tool.</source>
        <translation>求得的尖端已生效。要求另一工具，请重新开始。</translation>
    </message>
    <message>
        <source>{turned}° from the nearest pose taken; {wanted}° or more are wanted.</source>
        <translation>与最接近的已采集位姿相差 {turned}°；最好 {wanted}° 或更多。</translation>
    </message>
    <message>
        <source>On the shank</source>
        <translation>杆部</translation>
    </message>
    <message>
        <source>Fix a sharp point in front of the arm. Bring the tool&apos;s tip onto it (by Jog above, or lead the arm by hand), and press Take pose.</source>
        <translation>在机械臂前固定一个尖点，把工具尖端移到它上面（用上方的“点动”或用手拖动机械臂），再按“采集位姿”。</translation>
    </message>
    <message>
        <source>it points along {axis} of “{name}”</source>
        <translation>指向“{name}”的 {axis}</translation>
    </message>
    <message>
        <source>Apply the tip</source>
        <translation>应用尖端</translation>
    </message>
    <message>
        <source>Largest residual allowed</source>
        <translation>允许的最大残差</translation>
    </message>
    <message>
        <source>Puts the measured pose in the place of this one.</source>
        <translation>用实测位姿取代此位姿。</translation>
    </message>
    <message>
        <source>The residual says how well the poses fit, not how true the tool is.</source>
        <translation>残差说明各位姿相符的程度，不说明工具有多准。</translation>
    </message>
    <message>
        <source>It points so</source>
        <translation>已指向</translation>
    </message>
    <message>
        <source>Touch the point with the shank behind the tip; press On the shank.</source>
        <translation>用尖端后方的杆部触碰该点；再按“杆部”。</translation>
    </message>
    <message>
        <source>by two more points</source>
        <translation>再用两个点</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Tilt the tool by {wanted}° or more, touch the point, take the pose.</source>
        <translation>把工具倾斜 {wanted}° 或更多，触碰该点，采集位姿。</translation>
    </message>
    <message>
        <source>Takes the measured pose; nothing moves.</source>
        <translation>采集实测位姿；什么都不动。</translation>
    </message>
    <message>
        <source>RMS {rms} mm, largest {largest} mm, condition {condition}, {turned}° apart</source>
        <translation>均方根 {rms} mm，最大 {largest} mm，条件数 {condition}，相差 {turned}°</translation>
    </message>
    <message>
        <source>Pose {count} of at least {least} is taken. {turn}</source>
        <translation>已采集第 {count} 个位姿，至少 {least} 个。{turn}</translation>
    </message>
    <message>
        <source>The flange&apos;s {axis} axis has pointed {turned}° apart so far: turn about {about} by {wanted}° or more, touch the point, take the pose.</source>
        <translation>法兰 {axis} 轴的指向至今最多相差 {turned}°：请绕 {about} 再转 {wanted}° 或更多，触碰该点，采集位姿。</translation>
    </message>
    <message>
        <source>Turn the tool until it points along that axis; press It points so.</source>
        <translation>转动工具，直到它指向该轴；再按“已指向”。</translation>
    </message>
    <message>
        <source>Left out of the search while it is not ticked</source>
        <translation>不勾选则不参与求解</translation>
    </message>
    <message>
        <source>as before</source>
        <translation>不变</translation>
    </message>
    <message>
        <source>Found: {found}
Before: {before}</source>
        <translation>求得：{found}
原有：{before}</translation>
    </message>
    <message>
        <source>Take pose</source>
        <translation>采集位姿</translation>
    </message>
</context>
<context>
    <name>ToolBox</name>
    <message>
        <source>Tool centre point relative to the flange (mm, °), saved on this PC</source>
        <translation>工具中心点相对法兰（mm、°），保存在本机</translation>
    </message>
    <message>
        <source>Tool {axis}</source>
        <translation>工具 {axis}</translation>
    </message>
    <message>
        <source>The cell has no tool chosen; one is chosen under Cell</source>
        <translation>单元未选择工具；在“单元”中选择</translation>
    </message>
    <message>
        <source>Tool “{name}” of the cell (mm, °); it is changed under Cell</source>
        <translation>单元的工具“{name}”（mm，°）；在“单元”中更改</translation>
    </message>
</context>
<context>
    <name>ToolsTab</name>
    <message>
        <source>— (bare flange)</source>
        <translation>—（仅法兰）</translation>
    </message>
    <message>
        <source>Press Apply to put the new figures in force.</source>
        <translation>请按“应用”使新数值生效。</translation>
    </message>
    <message>
        <source>Delete the tool</source>
        <translation>删除工具</translation>
    </message>
    <message>
        <source>Press Add for a further tool, or Apply: the chosen one gets these.</source>
        <translation>按“添加”另加一个工具，或按“应用”把这个名称和数值给所选工具。</translation>
    </message>
    <message>
        <source>Radius of the tool&apos;s capsule</source>
        <translation>工具胶囊体的半径</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Add as a new tool</source>
        <translation>添加为新工具</translation>
    </message>
    <message>
        <source>Tool&apos;s name</source>
        <translation>工具名称</translation>
    </message>
    <message>
        <source>Puts these figures in the place of those of the chosen tool.</source>
        <translation>用这些数值取代所选工具的数值。</translation>
    </message>
    <message>
        <source>Adds a tool of this name; it is in force once it is chosen.</source>
        <translation>添加该名称的工具；选择后才生效。</translation>
    </message>
    <message>
        <source>Type it</source>
        <translation>手动输入</translation>
    </message>
    <message>
        <source>Tool on the flange</source>
        <translation>法兰上的工具</translation>
    </message>
    <message>
        <source>No tool is chosen. Add one, or choose one above.</source>
        <translation>未选择工具。请添加一个，或在上方选择。</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Deletes the chosen tool; the bare flange is chosen then.</source>
        <translation>删除所选工具；之后仅有法兰。</translation>
    </message>
    <message>
        <source>Apply the figures of the tool</source>
        <translation>应用工具的数值</translation>
    </message>
    <message>
        <source>Checks see a capsule from the flange to the tip, {length} mm long.</source>
        <translation>检查时视为从法兰到尖端的胶囊体，长 {length} mm。</translation>
    </message>
    <message>
        <source>This tool is in force. Choose another one, or change its figures.</source>
        <translation>此工具已生效。可另选一个，或更改其数值。</translation>
    </message>
    <message>
        <source>Type a name for the tool and what is known of it, then press Add.</source>
        <translation>请输入工具的名称和已知的数值，再按“添加”。</translation>
    </message>
    <message>
        <source>Find the tip by points</source>
        <translation>用点求尖端</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Disables all six motors: the arm will drop, so hold it first.</source>
        <translation>6 个电机全部失能：机械臂会下落，请先扶住机械臂。</translation>
    </message>
    <message>
        <source>Enables all six motors.</source>
        <translation>6 个电机全部使能。</translation>
    </message>
    <message>
        <source>Disable the motors</source>
        <translation>失能电机</translation>
    </message>
    <message>
        <source>The arm will drop when its motors are disabled. Hold the arm.</source>
        <translation>失能后机械臂会下落，请扶住机械臂。</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>失能</translation>
    </message>
</context>
<context>
    <name>TraceColumn</name>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>报文</translation>
    </message>
    <message>
        <source>Sender</source>
        <translation>发送方</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>内容</translation>
    </message>
</context>
<context>
    <name>TrajectoryCommand</name>
    <message>
        <source>Pause</source>
        <translation>暂停当前轨迹</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续当前轨迹</translation>
    </message>
    <message>
        <source>Clear current</source>
        <translation>清除当前轨迹</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>清除所有轨迹</translation>
    </message>
    <message>
        <source>Terminate</source>
        <translation>终止当前轨迹</translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Previous fault</source>
        <translation>上一个故障</translation>
    </message>
    <message>
        <source>Next fault</source>
        <translation>下一个故障</translation>
    </message>
    <message>
        <source>To the previous fault or stop</source>
        <translation>跳到上一个故障或急停</translation>
    </message>
    <message>
        <source>To the next fault or stop</source>
        <translation>跳到下一个故障或急停</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>回放速度</translation>
    </message>
    <message>
        <source>Multiple of the original speed. Above 4× not every frame is processed.</source>
        <translation>相对原速的倍数。超过 4× 时不逐帧处理。</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>Pause, at the moment of the frame before</source>
        <translation>暂停，退到前一帧的时刻</translation>
    </message>
    <message>
        <source>Pause, one frame further</source>
        <translation>暂停，前进一帧</translation>
    </message>
</context>
<context>
    <name>UncommandedMotion</name>
    <message>
        <source>The arm sinks: {down} mm lower after {seconds} s (J{joint} {turned}°), now at {speed} mm/s. Below it: {below}. Hold it.</source>
        <translation>机械臂正在下沉：{seconds} 秒内下沉 {down} mm（J{joint} {turned}°），当前 {speed} mm/s。下方：{below}。请扶住。</translation>
    </message>
    <message>
        <source>The arm sinks though its motors are on: {down} mm lower after {seconds} s (J{joint} {turned}°), now at {speed} mm/s. Below it: {below}. Hold it.</source>
        <translation>电机已使能，但机械臂仍在下沉：{seconds} 秒内下沉 {down} mm（J{joint} {turned}°），当前 {speed} mm/s。下方：{below}。请扶住。</translation>
    </message>
    <message>
        <source>The arm gives way, the tool no lower: J{joint} by {turned}° in {seconds} s, now at {speed} mm/s. Below it: {below}. Hold it.</source>
        <translation>机械臂在下坠，末端未降低：J{joint} 在 {seconds} 秒内转动 {turned}°，当前 {speed} mm/s。其下方：{below}。请扶住。</translation>
    </message>
    <message>
        <source>The arm moves, and no motor holds it: J{joint} by {turned}° in {seconds} s, now at {speed} mm/s.</source>
        <translation>机械臂在运动，且没有电机支撑：{seconds} 秒内 J{joint} 转动 {turned}°，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm moves, and no motor holds J{joint}: by {turned}° in {seconds} s, now at {speed} mm/s.</source>
        <translation>机械臂在运动，且 J{joint} 没有电机支撑：{seconds} 秒内转动 {turned}°，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm moves, and nothing told it to: J{joint} by {turned}° in {seconds} s, now at {speed} mm/s.</source>
        <translation>没有任何指令，机械臂却在运动：{seconds} 秒内 J{joint} 转动 {turned}°，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm moves, by a hand or its own weight: J{joint} by {turned}° in {seconds} s, {down} mm lower, now at {speed} mm/s.</source>
        <translation>机械臂在运动（手拖动或自重）：{seconds} 秒内 J{joint} 转动 {turned}°，下降 {down} mm，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm moves by itself along its taught path, or to its start: J{joint} by {turned}° in {seconds} s, now at {speed} mm/s.</source>
        <translation>机械臂正在自行沿示教轨迹运动，或前往其起点：{seconds} 秒内 J{joint} 转动 {turned}°，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm still moves: J{joint} by {turned}° in {seconds} s, now at {speed} mm/s.</source>
        <translation>机械臂仍在运动：{seconds} 秒内 J{joint} 转动 {turned}°，当前 {speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm is moved by hand, at {speed} mm/s.</source>
        <translation>正在用手拖动机械臂，{speed} mm/s。</translation>
    </message>
    <message>
        <source>The arm may be moving: it was last heard {ago} ago.</source>
        <translation>机械臂可能仍在运动：最后一次收到反馈是 {ago}前。</translation>
    </message>
    <message>
        <source>The arm may be moving: it stood still when last heard, {ago} ago.</source>
        <translation>机械臂可能仍在运动：{ago}前最后一次收到反馈时静止。</translation>
    </message>
    <message>
        <source>The arm may be moving: it moved at {speed} mm/s when last heard, {ago} ago.</source>
        <translation>机械臂可能仍在运动：{ago}前最后一次收到反馈时速度为 {speed} mm/s。</translation>
    </message>
    <message>
        <source>table or floor</source>
        <translation>台面或地面</translation>
    </message>
    <message>
        <source>{count} s</source>
        <translation>{count} 秒</translation>
    </message>
    <message>
        <source>{count} min</source>
        <translation>{count} 分钟</translation>
    </message>
</context>
<context>
    <name>UncommandedMotionShort</name>
    <message>
        <source>Sinks {down} mm, {speed} mm/s</source>
        <translation>下沉 {down} mm，{speed} mm/s</translation>
    </message>
    <message>
        <source>Moves, {speed} mm/s</source>
        <translation>在运动，{speed} mm/s</translation>
    </message>
    <message>
        <source>Moved by hand</source>
        <translation>手动拖动中</translation>
    </message>
    <message>
        <source>May be moving</source>
        <translation>可能仍在运动</translation>
    </message>
    <message>
        <source>Hold it. {does}.</source>
        <translation>请扶住。{does}。</translation>
    </message>
</context>
<context>
    <name>UncommandedMotionWord</name>
    <message>
        <source>Sinking</source>
        <translation>下沉中</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>No power</source>
        <translation>无力矩</translation>
    </message>
    <message>
        <source>Not heard</source>
        <translation>无反馈</translation>
    </message>
</context>
<context>
    <name>UnderWay</name>
    <message>
        <source>enabling the motors</source>
        <translation>使能电机</translation>
    </message>
    <message>
        <source>disabling the motors</source>
        <translation>失能电机</translation>
    </message>
    <message>
        <source>releasing the emergency stop</source>
        <translation>解除急停</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>reading or saving the arm&apos;s settings</source>
        <translation>读取或保存机械臂参数</translation>
    </message>
    <message>
        <source>the setting before</source>
        <translation>上一项设置</translation>
    </message>
    <message>
        <source>setting the linkage</source>
        <translation>设置联动</translation>
    </message>
    <message>
        <source>setting a zero</source>
        <translation>设置零点</translation>
    </message>
    <message>
        <source>clearing a joint&apos;s error</source>
        <translation>清除关节错误</translation>
    </message>
    <message>
        <source>a teaching command</source>
        <translation>示教指令</translation>
    </message>
    <message>
        <source>the step before</source>
        <translation>上一步操作</translation>
    </message>
</context>
<context>
    <name>UnknownCode</name>
    <message>
        <source>unknown ({code})</source>
        <translation>未知 ({code})</translation>
    </message>
</context>
<context>
    <name>UnlockButton</name>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Leaves the operator&apos;s view.</source>
        <translation>退出操作员视图。</translation>
    </message>
</context>
<context>
    <name>UnsavedQuestion</name>
    <message>
        <source>What you entered has not been saved to the arm. If you discard it, the arm keeps what it holds now.</source>
        <translation>输入的值尚未保存到机械臂。若放弃修改，机械臂保持现有的值。</translation>
    </message>
</context>
<context>
    <name>UnsavedRecordingLine</name>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Saves it in the library.</source>
        <translation>保存到轨迹库。</translation>
    </message>
    <message>
        <source>It stays under “Recently deleted…” for 30 days.</source>
        <translation>30 天内可在“最近删除…”中恢复。</translation>
    </message>
    <message>
        <source>Unsaved recording of {time}: “{name}”, {count} samples.</source>
        <translation>{time} 的录制尚未保存：“{name}”，{count} 个采样。</translation>
    </message>
</context>
<context>
    <name>ViewBar</name>
    <message>
        <source>Front view</source>
        <translation>前视图</translation>
    </message>
    <message>
        <source>Looks at the arm from the front</source>
        <translation>从机械臂正前方观察</translation>
    </message>
    <message>
        <source>Side view</source>
        <translation>侧视图</translation>
    </message>
    <message>
        <source>Looks at the arm from its right side</source>
        <translation>从机械臂右侧观察</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>俯视图</translation>
    </message>
    <message>
        <source>Looks down on the arm</source>
        <translation>从上方观察机械臂</translation>
    </message>
    <message>
        <source>Oblique view</source>
        <translation>轴测视图</translation>
    </message>
    <message>
        <source>Looks at the arm from the front right and above</source>
        <translation>从右前上方观察机械臂</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Follow the tool</source>
        <translation>跟随末端</translation>
    </message>
    <message>
        <source>Keeps the tool centre point in the middle</source>
        <translation>使工具中心点保持在画面中央</translation>
    </message>
    <message>
        <source>Parallel projection</source>
        <translation>平行投影</translation>
    </message>
    <message>
        <source>Parallel lines look parallel: lengths can be compared</source>
        <translation>平行线保持平行，可比较长度</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>工具坐标系</translation>
    </message>
    <message>
        <source>Shows the axes of the tool centre point</source>
        <translation>显示工具中心点的坐标轴</translation>
    </message>
    <message>
        <source>View from below</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>工作空间</translation>
    </message>
    <message>
        <source>User frames</source>
        <translation>用户坐标系</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存画面…</translation>
    </message>
    <message>
        <source>Writes the picture with its figures to a file</source>
        <translation>将画面连同数值保存为文件</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制画面</translation>
    </message>
    <message>
        <source>Puts the picture with its figures into the clipboard</source>
        <translation>将画面连同数值复制到剪贴板</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>观察方向</translation>
    </message>
    <message>
        <source>Last {seconds} s of motion</source>
        <translation>最近 {seconds} 秒的运动</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Views, and what is drawn in the picture</source>
        <translation>视角以及画面中显示的内容</translation>
    </message>
    <message>
        <source>No handles</source>
        <translation>不显示手柄</translation>
    </message>
    <message>
        <source>Looks at the arm from below the floor; turning the picture never goes there</source>
        <translation>从地面以下看机械臂；拖动旋转不会转到地面以下</translation>
    </message>
    <message>
        <source>Shows all of the arm, and the boxes of the work area, as large as the room allows</source>
        <translation>在空间允许的范围内尽量大地显示整个机械臂和工作区的盒子</translation>
    </message>
    <message>
        <source>Shows the user frames of the cell; the one in force has coloured axes</source>
        <translation>显示单元的用户坐标系；生效的坐标系以彩色轴显示</translation>
    </message>
    <message>
        <source>Tool, along the axes of its figures: base or user frame</source>
        <translation>末端，沿数值所在的坐标系（基坐标系或用户坐标系）各轴</translation>
    </message>
    <message>
        <source>Tool, along its own axes</source>
        <translation>末端，沿工具坐标系各轴</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Drag the target in the picture</source>
        <translation>在画面中拖动目标</translation>
    </message>
    <message>
        <source>Drags the target, or the chosen point, in the picture; the arm does not move. Ctrl: coarse steps, Shift: fine steps, Esc: give up</source>
        <translation>在画面中拖动目标或所选点，机械臂不会运动。Ctrl：大步进，Shift：小步进，Esc：放弃</translation>
    </message>
    <message>
        <source>Shows where the tool centre point can reach; orange outlines what it cannot reach within</source>
        <translation>显示工具中心点能到达的空间；橙色是其中到不了的部分的边界</translation>
    </message>
    <message>
        <source>Trail of the tool centre point</source>
        <translation>工具中心点走过的轨迹</translation>
    </message>
    <message>
        <source>Trail of the flange</source>
        <translation>法兰走过的轨迹</translation>
    </message>
    <message>
        <source>Work area</source>
        <translation>工作区</translation>
    </message>
    <message>
        <source>Shows the planes and boxes of the cell&apos;s work area; those near the arm are lit</source>
        <translation>显示单元工作区的平面和长方体；靠近机械臂的会亮起</translation>
    </message>
</context>
<context>
    <name>WatchMenu</name>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Feedback and commands of the last half hour. Right-click any figure to show it here.</source>
        <translation>最近半小时的反馈与指令。在任意数值上按右键即可在此显示。</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>What happened: every command and its result, every change of the arm&apos;s status, every fault with its beginning and end.</source>
        <translation>发生过的一切：每条指令及其结果、机械臂的每次状态变化、每个故障的开始与结束。</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>Every frame on the CAN bus: what it says, how often it comes, who sends it.</source>
        <translation>CAN 总线上的每一帧：含义、频率以及由谁发送。</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Record everything on the bus, save what just happened, replay what was recorded, here or by another program.</source>
        <translation>记录总线上的一切，保存刚才发生的事，回放本程序或其他程序的日志。</translation>
    </message>
    <message>
        <source>What each joint says of itself: temperature, current, voltage, faults.</source>
        <translation>各关节自报的状态：温度、电流、电压、故障。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>使用帮助</translation>
    </message>
    <message>
        <source>How to use the program; F1 opens it at the place where you are.</source>
        <translation>程序的用法；按 F1 打开当前所在处的章节。</translation>
    </message>
</context>
<context>
    <name>WholeCurves</name>
    <message>
        <source>The log is long: its last hour is shown.</source>
        <translation>日志较长：显示最后一小时。</translation>
    </message>
    <message>
        <source>Loading: {percent} %</source>
        <translation>正在载入：{percent} %</translation>
    </message>
</context>
<context>
    <name>WindowActions</name>
    <message>
        <source>There is no next step now.</source>
        <translation>现在没有下一步。</translation>
    </message>
    <message>
        <source>Close the trajectory editor first.</source>
        <translation>请先关闭轨迹编辑器。</translation>
    </message>
</context>
</TS>
