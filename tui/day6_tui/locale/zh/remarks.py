"""The programs' remarks."""

TEXTS = {
    "car.stays": "图上只画转角，车不会走。想让它跑：ros2 launch day6_world world.launch.py",
    # Beside the car
    "car.waiting_for_description": "还没有人发布 /robot_description：robot_state_publisher 在运行吗？",
    "car.loading": "正在读机器人描述",
    "car.bad_description": "机器人描述有错：{text}",
    "car.no_wheels": "这个机器人没有轮子：没有绕水平轴转动的东西",
    "car.no_joint_states": "没有人发布 {topic}：轮子不会转",
    "car.wrong_type": "{topic} 的类型是 {type}，应该是 sensor_msgs/msg/JointState",
    "car.unknown_joint": "URDF 里没有关节 {joint}",
    "car.unknown_joint_near": "URDF 里没有关节 {joint}，是不是想写 {nearest}？",
    "car.no_transform": "没有从 {link} 到 {frame} 的坐标变换",
    "car.no_transform_more": "还有 {count} 个 link 没有到 {frame} 的坐标变换",
    "car.many_publishers": "{topic} 上有 {count} 个发布者：{nodes}",
    "car.slow": "{topic} 每秒只来 {rate} 次：眼睛需要大约 20 次",
    "car.silent": "{topic} 已经 {seconds} 秒没有消息",
    # Below the world
    "world.waiting_for_robot": "世界里还没有机器人：还没有人发布 /robot_description",
    "world.refused": "{robot} 不能进入这个世界：",
    "world.bad_description": "机器人描述有错：{text}",
    "world.left_away": "机器人有些部分读不出来：{text}",
    "world.no_inertial": "{links}：没有 <inertial>。没有质量的东西，力推不动它，它就是个“幽灵”",
    "world.bad_mass": "{link}：质量不能是 {mass} 千克",
    "world.bad_inertia": "{link}：绕每根轴的转动惯量都要大于 0",
    "world.bad_number": "{link}：有个尺寸或位置不是数",
    "world.no_drive": "找不到一左一右两个能驱动它的轮子",
    "world.stands_in_wall": "在 ({x:.2f}, {y:.2f}) 它会站到墙里",
    "world.no_collision": "{links}：没有 <collision>，会像幽灵一样穿墙",
    "world.wheels_without_collision": "{links}：轮子没有 <collision>，碰不到地面，只会空转，推不动车",
    "world.nobody_drives": "没有人发布 {topic}：运行 ros2 run teleop_twist_keyboard teleop_twist_keyboard 就能开车",
    "world.keeps_going": "{topic} 上已经没有人发布了：最后一条命令一直有效，直到有新的命令",
    "world.wrong_type": "{topic} 的类型是 {type}，这个世界听的是 {wanted}：启动时加上 stamped:={stamped}",
    "world.two_joint_states": (
        "{nodes} 也在发布 {topic}。这个话题只报告轮子在哪里，不是命令，所以车不会走。"
        "加上 -r joint_states:=joint_commands，它就成了命令"
    ),
    "world.bumped": "碰到墙了：轮子在打滑，而 /odom 不知道",
    "world.sideways": "linear.y 没有用：两个轮子的车不能横着走",
    # The inspector's findings
    "inspector.unheard": "{topic}：{nodes} 在发布，但没有人听",
    "inspector.unsaid": "{topic}：{nodes} 在听，但没有人发布",
    "inspector.near": "有人发布 {published}，有人在听 {subscribed}：是不是有一个名字写错了？",
    "inspector.types": "{topic}：{publisher} 发的是 {sent}，{subscriber} 要的是 {wanted}，什么也收不到",
    "inspector.qos": "{topic}：{publisher} 的 QoS 和 {subscriber} 的对不上（{policy}），什么也收不到",
    "inspector.fight": "{topic}：有 {count} 个发布者同时在发，互相打架：{nodes}",
    "inspector.twins": "有 {count} 个节点都叫 {name}：列表和参数分不清它们",
    "inspector.unknown_joint": "{topic}：{nodes} 发了关节 {joint}，机器人描述里没有这个关节",
    "inspector.unknown_joint_near": (
        "{topic}：{nodes} 发了关节 {joint}，机器人描述里没有，所以 {link} 在 TF 里没有位置；是不是想写 {nearest}？"
    ),
    "inspector.other_joints": "{topic}：{nodes} 发的是 {joint}，机器人描述里的关节却叫 {joints}：{links} 在 TF 里没有位置",
    "inspector.silent_joint": "{topic}：{nodes} 没有发 {joint} 的位置，所以 {links} 在 TF 里没有位置",
    "inspector.no_joint_states": "没有人发布 {topic}：没有人说 {joints} 转到了哪里，所以 {links} 在 TF 里没有位置",
    "inspector.trajectory_joint": "{topic}：{node} 指挥关节 {joint}，机器人没有这个关节",
    "inspector.trajectory_joint_near": "{topic}：{node} 指挥关节 {joint}，机器人没有这个关节；是不是想写 {nearest}？",
    "inspector.joint_limits": (
        "{topic}：{node} 发的 {joint} 是 {position}，超出了 {low} 到 {high} 的限位：是不是写成了角度？ROS 用弧度"
    ),
    "inspector.two_descriptions": "{nodes} 在 /robot_description 上发的不是同一个机器人：后启动的程序收到哪一个全凭运气",
    "inspector.not_finite": "{topic}：{node} 发的 {field} 是 {value}，谁也没法拿它计算",
    "inspector.quaternion": (
        "{topic}：{node} 的四元数 {field} 长度是 {length}，应该是 1，所以它不是旋转；用角度换算，不转就写 w = 1"
    ),
    "inspector.data_size": "{topic}：{node} 的 {field} 是 {count}，按消息里别的字段应该是 {expected}",
    "inspector.image_encoding": "{topic}：{node} 把编码写成 {encoding}，应该写 {right}",
    "inspector.map_resolution": "{topic}：{node} 的地图分辨率是 {resolution} 米：格子没有大小",
    "inspector.out_of_range": "{topic}：{node} 发的 {field} 是 {value}，它只能在 {low} 到 {high} 之间",
    "inspector.scan_angles": (
        "{topic}：{node} 发了 {ranges} 个距离，可是按 angle_min、angle_max 和 angle_increment（{step}）应该有 {angles} 个"
    ),
    "inspector.scan_degrees": "{topic}：{node} 扫描到的角度是 {angle}：这是度，ROS 用弧度",
    "inspector.scan_empty": "{topic}：{node} 的 {ranges} 个距离没有一个是数：这个激光雷达什么也看不见",
    "inspector.scan_ranges": "{topic}：{node} 的 range_min 是 {low}，range_max 是 {high} 米：没有一个距离有效",
    "inspector.empty_frame": "{topic}：{node} 发的 {type} 里坐标系名是空的，谁也不知道它在哪里",
    "inspector.unknown_frame": "{topic}：{node} 发的 {type} 在坐标系 {frame} 里，可是没有人发它的变换",
    "inspector.unknown_frame_near": (
        "{topic}：{node} 发的 {type} 在坐标系 {frame} 里，可是没有人发它的变换；是不是想写 {nearest}？"
    ),
    "inspector.stampless": "{topic}：{node} 的 header.stamp 是 0：把它设成 node.get_clock().now().to_msg()",
    "inspector.stamp_1970": (
        "{topic}：{node} 的时间戳是 {stamp} 秒，也就是 1970 年：它用的不是大家的时钟。"
        "要用 node.get_clock().now().to_msg()"
    ),
    "inspector.stamp_past": "{topic}：{node} 发的东西，时间戳是 {time} 以前，对 TF 来说太旧了",
    "inspector.stamp_future": "{topic}：{node} 发的东西，时间戳比现在早了 {time}，还在将来",
    "inspector.stamp_clock": "{topic}：{node} 用的是电脑的时间，可 /clock 说的是另一个时间：它需要 use_sim_time",
    "inspector.tf_loop": "坐标变换绕成了一个圈：{frames}（{nodes} 发的）；圈里的东西都没有位置",
    "inspector.tf_nameless": "{nodes} 发的坐标变换里有一个空的坐标系名（另一个是 {frame}）",
    "inspector.tf_fight": "{nodes} 发的从 {parent} 到 {child} 的变换不一样：它会跳来跳去",
    "inspector.two_parents": "坐标系 {child} 有几个上级：{parents}（{nodes} 发的）。只能有一个，所以它在它们之间跳来跳去",
    "inspector.slow": "{topic} 每秒只来 {rate} 次；眼睛要看得顺，大约需要 20 次",
    "inspector.late": "这台电脑忙不过来：时间只走到 {pace} 倍速，本来应该是 {speed} 倍，所以各个话题的频率都比程序设定的低",
    "inspector.open": "{endpoint} 已开放，{joined} 台已加入；没有口令：能连到这个端口的人都能读取和指挥",
    "inspector.open_class": "{endpoint} 已开放，{joined} 台已加入；没有口令：能连到这个端口的人都能加入这个班",
    "inspector.open_secret": "{endpoint} 已向知道口令的机器开放，{joined} 台已加入",
    "inspector.opening": "{endpoint} 即将开放",
    "inspector.in_use": "{endpoint}：这个端口被别的程序占用，其他机器无法加入；会再试",
    "inspector.no_name": "{endpoint}：没有人认识这个名字；会再试",
    "inspector.shut": "{endpoint} 无法开放（{reason}），其他机器无法加入；会再试",
    "inspector.calling": "正在呼叫 {endpoint}",
    "inspector.joined": "已加入 {endpoint}",
    "inspector.nobody": "{endpoint} 没有应答：机器在，但没有程序监听这个端口；会再试",
    "inspector.no_answer": "{endpoint} 没有应答；会再试",
    "inspector.wrong_secret": "被 {endpoint} 拒绝：口令不对，或者对方没有设口令",
    "inspector.no_secret": "被 {endpoint} 拒绝：对方要求口令，或者那不是 ROS",
    "inspector.no_class": "{endpoint} 有应答，但那里没有在上课；会再试",
    "inspector.name_taken": "{endpoint}：班里已经有人用了你的名字；会再试",
    "inspector.name_alike": "{endpoint}：班里有人的名字看上去和你的一样；会再试",
    "inspector.class_full": "{endpoint}：班级已满；会再试",
    "inspector.other_domain": "{endpoint}：这个房间的 ROS_DOMAIN_ID 和你的不同；会再试",
    "inspector.unreachable": "无法呼叫 {endpoint}（{reason}）；会再试",
    "inspector.alone": "看不到其他进程的程序：{reason}",
    "inspector.with_zenoh": "有 {count} 个你的进程用 Zenoh，这里没有用：看不到它们",
    "inspector.elsewhere": "与其他进程会合没有用通常的文件夹：{reason}",
    "inspector.refused_many": "拒绝了其他进程的 {count} 个声明：太多了",
    "inspector.refused_names": "拒绝了其他进程的 {count} 个声明：ROS 不允许这样的名字",
    "inspector.refused_messages": "其他进程的 {count} 条消息无法读取，已丢弃",
    "inspector.refused_sessions": "拒绝了其他机器的 {count} 项内容：它们冒充本机的进程",
    "inspector.not_built": "`{line}`：{package} 在 {folder} 里，但还没有编译",
    "inspector.not_sourced": (
        "`{line}`：{package} 已经编译好了，但终端 {number} 不知道它：终端开得比编译早，或者还没有 source"
    ),
    "inspector.nowhere_sourced": "{packages}：已经编译好了，但还没有一个终端知道它",
    "inspector.no_entry_point": (
        "`{line}`：{package} 里有文件 {executable}，但 setup.py 的 entry_points 没有写它：加上 {entry}，再编译"
    ),
    "inspector.entry_not_built": "`{line}`：setup.py 里写了 {executable}，但之后没有再编译 {package}",
    "inspector.no_setup_cfg": "{package}：程序装到了 `ros2 run` 不去找的地方：缺少写着 script_dir 的 setup.cfg",
    "inspector.entry_py": "{package}：entry_points 里的 {entry} 写成了 {wrong}；模块名不带 .py，要写 {right}",
    "inspector.entry_module": "{package}：entry_points 里的 {entry} 指向 {module}，可是没有这个文件",
    "inspector.entry_function": (
        "{package}：entry_points 里的 {entry} 指向 {module}:{function}，可是那个文件里没有函数 {function}"
    ),
    "inspector.entry_form": "{package}：entry_points 里的 {entry} 没写成 '名字 = 包名.文件名:main'",
    "inspector.launch_not_built": "`{line}`：{package} 的 setup.py 里已经加了 {file}，但之后没有再编译",
    "inspector.launch_not_installed": (
        "{package}：{file} 没有被安装：{where} 里（data_files）没有写它，所以 `ros2 launch` 找不到"
    ),
    "inspector.not_rebuilt": "{package}：{files} 在编译之后改过；现在运行的还是旧的",
    "inspector.inner_package": "功能包 {inner} 放在 {outer} 的文件夹里面：colcon 不会去那里找。把它移到 src 里",
    "inspector.stray_build": "{folder} 里多出一套编译结果：有人在那里运行了 colcon。只在工作空间里编译，把这一套删掉",
    "inspector.unreadable": "读不了：{what}",
    "inspector.mixed_types": "{topic}：{nodes} 发布的类型不一样：{types}",
    "inspector.ctrl_c": "`{line}`：这段 traceback 只是你按了 Ctrl-C，没有东西坏掉",
    "inspector.no_server": "{nodes} 想调用 {name}，但没有人提供它",
    "inspector.service_near": "{nodes} 想调用 {name}，但只有 {near}：是不是有一个名字写错了？",
    "inspector.said_too_soon": "{topic}：{node} 发布的时候，在听的人还没有找到它，之后它再也没发：要先等到有人订阅",
    "inspector.gone_too_soon": "{topic}：{node} 只存在了 {seconds} 秒，没有人听到它：只发一次的话，要先等到有人订阅",
    "inspector.never_spun": "{node} 从来没有 spin：它的回调不会运行。{program} 里要写 rclpy.spin(node)",
    "inspector.spin_ended": "{node}：现在没有人 spin 它，它的回调都在等。{program} 是离开了 spin，还是在睡觉？",
    "inspector.ended_unspun": "{program} 马上就结束了：里面没有 spin，回调没有机会运行。要写 rclpy.spin(node)",
    "inspector.calls_in_callback": (
        "{node}：{what} 在等 {name} 的回答（{where}），可是唯一的线程被它自己占着，没有人能收这个回答。"
        "要用 call_async 和完成后的回调"
    ),
    "inspector.calls_in_group": (
        "{node}：{what} 在等 {name} 的回答（{where}），可是这个客户端和 {what} 在同一个 MutuallyExclusiveCallbackGroup 里，"
        "回答没人收。给客户端单独一个组"
    ),
    "inspector.calls_own_service": (
        "{node}：{what} 在等 {name}（{where}），这个服务由同一个程序里的 {other} 提供；"
        "{what} 占着唯一的线程，{other} 就运行不了。直接调用函数，或者用 call_async"
    ),
    "inspector.calls_own_in_group": (
        "{node}：{what} 在等 {name}（{where}），这个服务由同一个程序里的 {other} 提供；{other} 运行不了："
        "它和 {what} 在同一个 MutuallyExclusiveCallbackGroup 里。给其中一个单独的组"
    ),
    "inspector.future_in_callback": (
        "{node}：{what} 在等一个 future（{where}：{text}），可是让它完成的那个回调这时不能运行。要用 add_done_callback"
    ),
    "inspector.event_in_callback": (
        "{node}：{what} 在等一个事件（{where}：{text}）；这段时间别的回调都不能运行，也就没有谁能触发它"
    ),
    "inspector.input_in_callback": (
        "{node}：{what} 在等键盘输入（{where}：{text}）；这段时间别的回调都不能运行。放到单独的线程里去问"
    ),
    "inspector.spins_in_callback": "{node}：{what} 在回调里又 spin（{where}），这样永远不会返回。要用 call_async 和完成后的回调",
    "inspector.rate_in_callback": "{node}：{what} 用 Rate 睡觉（{where}），可它的定时器这时不能运行。要用定时器",
    "inspector.waits_in_callback": "{node}：{what} 在等服务（{where}）；这段时间别的回调都不能运行",
    "inspector.sleeps_in_callback": "{node}：{what} 在 {where} 睡觉：{text}；这段时间别的回调都不能运行。要用定时器",
    "inspector.stays_in_callback": "{node}：{what} 一直不返回（{where}：{text}）；这段时间别的回调都不能运行",
    "inspector.rate_alone": "{node}：{where} 的 rate.sleep() 会永远等下去：要有第二个线程来 spin 这个节点",
    "inspector.call_alone": "{node}：{where} 的 call() 会永远等下去：要有第二个线程来 spin 这个节点",
    "inspector.program_waits_service": "{node} 在 {where} 等服务 {name}，但没有人提供它",
    "inspector.program_waits_action": "{node} 在 {where} 等动作 {name}，但没有人提供它",
    "inspector.program_waits_near": "{node} 在 {where} 等 {name}，可是只有 {near}：是不是有一个名字写错了？",
    "inspector.program_waits_type": "{node} 在 {where} 等 {name}：有人提供它，但类型不一样（{type}）",
    "inspector.stays_in_init": (
        "{node}：它的 __init__ 一直不返回（{where}：{text}），所以程序走不到 spin。把循环改成定时器"
    ),
    "inspector.thread_died": "{program}：错误 {error}（{where}）让线程 {thread} 结束了；程序的其余部分还在继续，只是少了它",
    "inspector.exception_shown": "{where}：程序报告了 {error}，然后继续运行",
    "inspector.swallowed": (
        "{node}：{what} 每次都失败，却没人看见：{error}（出在 {raised}）在 {where} 被接住，那里什么也不做。至少把它打印出来"
    ),
    "inspector.timer_late": (
        "{node}：{what}（{where}）的定时器应该每秒运行 {wanted} 次，实际只有 {rate} 次：回调用的时间比周期长"
    ),
    "inspector.timer_zero": (
        "{node}：{what}（{where}）的定时器周期是 0：它会不停地运行（每秒 {rate} 次），别的事都没时间做"
    ),
    "inspector.timer_seldom": (
        "{node}：{what}（{where}）的定时器每 {period} 秒才调用一次；create_timer 的单位是秒，不是毫秒"
    ),
    "inspector.losses": (
        "{node} 在 {topic} 上丢了最近 {count} 条消息里的 {lost} 条：每秒来 {rate} 条，{what}（{where}）处理不过来，"
        "排队最久的会被覆盖"
    ),
    "inspector.flood": "{node} 在 {topic} 上每秒发布 {rate} 条消息：是不是有个循环没有停顿？要用定时器",
    "inspector.grows_publishers": (
        "{node} 的发布者越来越多（已经有 {count} 个，最后一个在 {name} 上）：create_publisher 要写在 __init__ 里，"
        "不要写在回调或循环里"
    ),
    "inspector.grows_subscriptions": (
        "{node} 的订阅越来越多（已经有 {count} 个，最后一个在 {name} 上）：create_subscription 要写在 __init__ 里，"
        "不要写在回调或循环里"
    ),
    "inspector.grows_clients": (
        "{node} 的客户端越来越多（已经有 {count} 个，最后一个是 {name} 的）：create_client 要写在 __init__ 里，"
        "不要写在回调或循环里"
    ),
    "inspector.grows_services": (
        "{node} 的服务越来越多（已经有 {count} 个，最后一个是 {name}）：create_service 要写在 __init__ 里，不要写在回调或循环里"
    ),
    "inspector.grows_timers": "{node} 的定时器越来越多（已经有 {count} 个）：{name} 要写在 __init__ 里，不要写在回调或循环里",
    "inspector.goal_unsettled": (
        "{node}：动作 {name} 的 {what}（{where}）返回了，却没有调用 succeed()、abort() 或 canceled()，所以这个目标算作失败"
    ),
    "inspector.goal_waits": "{node}：{name} 的一个目标接受了，却没有人执行它：{what} 里要调用 goal_handle.execute()",
    "inspector.cancel_ignored": (
        "{node}：有人取消了 {name} 的一个目标，可是 {what} 还在继续：要检查 goal_handle.is_cancel_requested，再调用 canceled()"
    ),
    "inspector.cancel_unheard": (
        "{node}：有人想取消 {name} 的一个目标，可是 {what} 占着唯一的线程：要用 MultiThreadedExecutor 和 ReentrantCallbackGroup"
    ),
    "inspector.empty_list": (
        "{node}：参数 {name} 是一个空的字节列表（BYTE_ARRAY），别的列表都设不进去：如果 [] 是想写文字或数字的列表，"
        "声明时要用 Parameter.Type.STRING_ARRAY 之类的类型"
    ),
    "inspector.launch_text": (
        '{node}：参数 {name} 的值是 {value}：launch 文件太早把 LaunchConfiguration 变成了文字（f"…"、str() 或 +），'
        "那时它还没有值；要把它放进列表里"
    ),
    "inspector.launch_argument": (
        '{node} 启动时得到的是 {value}：launch 文件太早把 LaunchConfiguration 变成了文字（f"…"、str() 或 +），'
        "那时它还没有值；要把它放进列表里"
    ),
    "inspector.sync_silent": "{node} 想把 {topics} 的消息配在一起，可是 {silent} 上什么也没来",
    "inspector.sync_no_callback": "{node} 把 {topics} 的消息配好了，却没有调用谁：少了 registerCallback",
    "inspector.sync_timeless": (
        "{node} 想把 {topics} 的消息配在一起，可是有的没有 header.stamp：allow_headerless=True 会用收到的时间"
    ),
    "inspector.sync_queue": (
        "{node} 一直配不上 {topics} 的消息：别的消息到的时候，{short} 里该和它配的（早 {gap} 秒）已经扔掉了。"
        "{size} 条太少，要把 queue_size 改大"
    ),
    "inspector.sync_stamps": (
        "{node} 一直配不上 {topics} 的消息：它们的时间相差 {gap} 秒，而 slop 只允许 {slop} 秒。是不是有一个用了别的时钟？"
    ),
    "inspector.sync_exact": (
        "{node} 一直配不上 {topics} 的消息：它们的时间从来不完全相等（相差 {gap} 秒）。要用 ApproximateTimeSynchronizer"
    ),
    "inspector.hidden_error": "{node} 丢了一个没人看见的异常：{error}（{where}）",
    "inspector.no_clock": "{node} 用的是仿真时间，但没有人发过 /clock：它的定时器都停着",
    "inspector.tells_nothing": "{node}：它的程序没有回应；可能被停住了（Ctrl-Z），或者太忙，所以没法看到它里面",
    "inspector.parameter_file": "读不了参数文件 {file}：{reason}",
    "inspector.parameter_keys": "{file} 是写给 {keys} 的，但没有节点叫这个名字（现在有 {nodes}）：里面的值不起作用",
    "inspector.parameter_nothing": "{file} 里没有 ros__parameters：里面的值不起作用",
    "inspector.domains": "终端 {number} 的 ROS_DOMAIN_ID 是 {domain}，看不到在 {other} 里运行的 {nodes}",
    "inspector.no_stamp": "{topic}：header.stamp 是 0，所以 robot_state_publisher 不理它：把它设成时钟的 now()",
    "inspector.unequal_joints": "{topic} 里有 {names} 个名字、{positions} 个位置；这样的消息会被忽略",
    "inspector.no_state_publisher": "{nodes} 在发 {topic}，但 robot_state_publisher 没有运行：没有人把它变成坐标变换",
    "inspector.rviz_no_description": "RViz 在等机器人，但没有人发布 /robot_description：robot_state_publisher 在运行吗？",
    "inspector.bad_description": "机器人描述有错：{reason}",
    "inspector.wheel_tumbles": '轮子 {link} 转的轴和圆柱的轴不是同一根，转起来会乱晃：在 <visual> 里写 rpy="1.5707963 0 0"',
    "inspector.wheel_no_axis": "关节 {joint} 没有转轴：0 0 0 不是一个方向",
    "inspector.wheel_stuck": "关节 {joint} 只能从一个角度动到同一个角度：轮子应该用 continuous 类型",
    "inspector.wheel_height": "轮子 {links} 不在同一个地面上：最低点相差 {difference} 米（看它们关节的 origin）",
    "inspector.body_low": "{link} 比轮子 {links} 还低 {difference} 米：机器人会趴在地上（看轮子关节的 origin）",
    "inspector.fixed_frame": "RViz：没有人发送 Fixed Frame {frame}；选 {other}（已知：{frames}）",
    "inspector.no_transforms": "RViz：没有人发送坐标变换，连 Fixed Frame {frame} 也不知道在哪里",
    "inspector.untransformed": "RViz：没有从 {links} 到 {frame} 的变换：没有人发送通到那里的关节",
    "inspector.no_robot_model": "RViz 没有显示机器人，因为没有 RobotModel 显示：点 Add，选 RobotModel",
    "inspector.robot_model_deaf": "RViz：RobotModel 听的是 {topic}，没有收到描述：把 Description Topic 设成 {right}",
    "inspector.unseen.terminals": "没有看：终端（只有桌面里才有）",
    "inspector.unseen.files": "没有看：工作空间里的文件",
    "inspector.unseen.programs": "没有看到里面：{names} 的程序，它们不报告自己的情况",
    "inspector.unseen.messages": "没有看：{names}，这里读不了它们的消息",
    "inspector.unseen.topics": "没有看：另外 {names} 个话题上发的内容，话题太多了",
    "inspector.looked": "看过：{sights}",
    "inspector.absent": "这里没有，所以没有看：{sights}",
    "inspector.sight.nodes": "节点",
    "inspector.sight.topics": "话题",
    "inspector.sight.messages": "消息",
    "inspector.sight.services": "服务",
    "inspector.sight.frames": "坐标系",
    "inspector.sight.joints": "关节",
    "inspector.sight.windows": "RViz 和世界窗口",
    "inspector.sight.programs": "程序（里面）",
    "inspector.sight.terminals": "终端",
    "inspector.sight.packages": "功能包",
    "inspector.sight.machines": "其他机器",
    "inspector.quiet.drill": (
        "练习里要自己找问题：解决或放弃以前，检查器什么也不说。看看程序说了什么，再看看 `ros2 node list`、"
        "`ros2 topic list`、`ros2 topic info -v`；看不懂的话，输入 `why`。"
    ),
    "inspector.quiet.exam": (
        "考试里要自己找问题：这一题解决以前，检查器什么也不说。看看程序说了什么，再看看 `ros2 node list`、"
        "`ros2 topic list`、`ros2 topic info -v`。"
    ),
    "inspector.well": "看过的地方没有发现问题",
    "rviz.missing.particles": "这里没有 {type} 这个类：它画 nav2_amcl 的粒子（nav2_msgs/ParticleCloud）；它会留在文件里",
    "rviz.missing.nav2_goal": (
        "这里没有 {type} 这个类：它给 Navigation2 一个目标；rviz_default_plugins/SetGoal 会把目标发到 /goal_pose；它会留在文件里"
    ),
    "rviz.missing.nav2": "这里没有 {type} 这个类：它是 Navigation2 的；它会留在文件里",
    "rviz.missing.moveit": "这里没有 {type} 这个类：它是 MoveIt 的；它会留在文件里",
    "rviz.missing.slam_toolbox": "这里没有 {type} 这个类：它是 slam_toolbox 的；它会留在文件里",
    "rviz.missing.imu": "这里没有 {type} 这个类：它是软件包 rviz_imu_plugin 的，把 Imu 画成坐标轴或方块；它会留在文件里",
    "rviz.missing.ros1_same": (
        "这里没有 {type} 这个类：这是 ROS 1 的文件；在 ROS 2 里它叫 rviz_default_plugins/{name}；它会留在文件里"
    ),
    "rviz.missing.ros1": "这里没有 {type} 这个类：这是 ROS 1 的文件；它会留在文件里",
    "rviz.missing.misspelt": "这里没有 {type} 这个类：{package} 里没有这个名字；它会留在文件里",
    "rviz.missing.plugin": "这里没有 {type} 这个类：它是软件包 {package} 的；它会留在文件里",
}
